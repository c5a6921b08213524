package raytracing.nasty;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * Draws many nasty scenes: {@code gradle nastyScenes [-Pscenes=100000] [-Pseed=1]}. Fails if a pixel of one is no light,
 * something is thrown, or one takes more than five seconds of a processor; writes those under build/nasty. One is drawn after
 * the other, as what a picture takes is the time of all threads of the program.
 */
public final class NastyScenes {
    private static final Path FOLDER = Path.of("build/nasty");
    private static final int THREADS = 2;
    private static final int TILE_SIZE = NastyDrawing.SIZE / 2;
    private static final int SLOWEST_SHOWN = 10;
    private static final double MOST_SECONDS = 5;
    private static final double SECONDS_OF_A_NANOSECOND = 1e-9;
    private static final OperatingSystemMXBean CLOCK =
        ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
    private static final int SCENES_OF_A_REPORT = 5000;

    private final List<Timed> slowest = new ArrayList<>();
    private int defects;

    private record Timed(long seed, double seconds) {
    }

    private NastyScenes() {
    }

    /**
     * Draws them.
     *
     * @param arguments how many scenes; the first one's seed
     * @throws IOException if a scene cannot be written
     */
    public static void main(String[] arguments) throws IOException {
        Files.createDirectories(FOLDER);
        long count = Long.parseLong(arguments[0]);
        long first = Long.parseLong(arguments[1]);
        NastyScenes scenes = new NastyScenes();
        for (long seed = first; seed < first + count; seed++) {
            scenes.draw(NastyScene.of(seed));
        }
        System.out.println(count + " scenes, " + scenes.defects + " defects; the slowest:");
        scenes.slowest.forEach(scene ->
            System.out.printf("seed %d: %.0f ms%n", scene.seed, 1000 * scene.seconds));
        if (scenes.defects > 0) {
            throw new IllegalStateException(scenes.defects + " scenes with defects, see " + FOLDER);
        }
    }

    private void draw(NastyScene scene) {
        long before = CLOCK.getProcessCpuTime();
        Optional<String> defect =
            NastyDrawing.defect(scene.scene(), scene.settings().withWorkers(THREADS, TILE_SIZE));
        double seconds = SECONDS_OF_A_NANOSECOND * (CLOCK.getProcessCpuTime() - before);
        if (defect.isEmpty() && seconds > MOST_SECONDS) {
            defect = Optional.of("takes " + seconds + " s");
        }
        note(new Timed(scene.seed(), seconds), scene, defect);
    }

    private void note(Timed timed, NastyScene scene, Optional<String> defect) {
        slowest.add(timed);
        slowest.sort(Comparator.comparingDouble(Timed::seconds).reversed());
        if (slowest.size() > SLOWEST_SHOWN) {
            slowest.remove(SLOWEST_SHOWN);
        }
        if (defect.isPresent()) {
            defects++;
            write(scene, defect.get());
            System.out.println("seed " + scene.seed() + ": " + defect.get());
        }
        if (scene.seed() % SCENES_OF_A_REPORT == 0) {
            System.out.println("drawn up to seed " + scene.seed());
        }
    }

    private static void write(NastyScene scene, String defect) {
        try {
            Files.writeString(FOLDER.resolve(scene.seed() + ".txt"),
                "# " + defect + "\n# " + scene.settings() + "\n" + scene.text());
        } catch (IOException unwritable) {
            throw new UncheckedIOException(unwritable);
        }
    }
}
