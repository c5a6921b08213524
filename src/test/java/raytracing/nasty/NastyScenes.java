package raytracing.nasty;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Draws many nasty scenes: {@code gradle nastyScenes [-Pscenes=100000] [-Pseed=1]}. Fails if a pixel of one is no light,
 * something is thrown, or one takes more than five seconds of a processor; writes those under build/nasty.
 */
public final class NastyScenes {
    private static final Path FOLDER = Path.of("build/nasty");
    private static final int THREADS = 2;
    private static final int SLOWEST_SHOWN = 10;
    private static final double MOST_SECONDS = 5;
    private static final double SECONDS_OF_A_NANOSECOND = 1e-9;
    private static final ThreadMXBean CLOCK = ManagementFactory.getThreadMXBean();
    private static final int SCENES_OF_A_REPORT = 5000;

    private final long end;
    private final AtomicLong next;
    private final List<Timed> slowest = new ArrayList<>();
    private int defects;

    private record Timed(long seed, double seconds) {
    }

    private NastyScenes(long first, long count) {
        next = new AtomicLong(first);
        end = first + count;
    }

    /**
     * Draws them.
     *
     * @param arguments how many scenes; the first one's seed
     * @throws IOException if a scene cannot be written
     * @throws InterruptedException if somebody does not want to wait for the end
     */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        Files.createDirectories(FOLDER);
        long count = Long.parseLong(arguments[0]);
        NastyScenes scenes = new NastyScenes(Long.parseLong(arguments[1]), count);
        scenes.drawAll();
        System.out.println(count + " scenes, " + scenes.defects + " defects; the slowest:");
        scenes.slowest.forEach(scene ->
            System.out.printf("seed %d: %.0f ms%n", scene.seed, 1000 * scene.seconds));
        if (scenes.defects > 0) {
            throw new IllegalStateException(scenes.defects + " scenes with defects, see " + FOLDER);
        }
    }

    private void drawAll() throws InterruptedException {
        List<Thread> threads = new ArrayList<>();
        for (int i = 0; i < THREADS; i++) {
            threads.add(new Thread(this::drawSome));
        }
        threads.forEach(Thread::start);
        for (Thread thread : threads) {
            thread.join();
        }
    }

    private void drawSome() {
        for (long seed = next.getAndIncrement(); seed < end; seed = next.getAndIncrement()) {
            NastyScene scene = NastyScene.of(seed);
            long before = CLOCK.getCurrentThreadCpuTime();
            Optional<String> defect = NastyDrawing.defect(scene);
            double seconds = SECONDS_OF_A_NANOSECOND * (CLOCK.getCurrentThreadCpuTime() - before);
            if (defect.isEmpty() && seconds > MOST_SECONDS) {
                defect = Optional.of("takes " + seconds + " s");
            }
            note(new Timed(seed, seconds), scene, defect);
        }
    }

    private synchronized void note(Timed timed, NastyScene scene, Optional<String> defect) {
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
