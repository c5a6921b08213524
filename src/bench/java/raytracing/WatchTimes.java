package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;

/** Prints how soon a small scene is there again after a save under {@code --watch}, on a virtual screen. */
public final class WatchTimes {
    /** README's first scene. */
    private static final String SCENE = """
        cam   0 2 -6    0 0.5 0    0 1 0    1  1
        set   0.6 0.7 0.9    4  5
        mtl   0.8 0.1 0.1    0.5 0.5 0.5    0.1 0.1 0.1    40  0
        mtl   0.6 0.6 0.6    0   0   0      0   0   0      1   0
        sph   0 1 0    1  1
        pln   0 1 0    0  2
        lgt   4 6 -5    0.8 0.8 0.7    1  0.9  1.5
        lgt  -6 9 -9    0.3 0.3 0.4    0  0    0
        """;

    /** The virtual machine is warm after these. */
    private static final int NOT_COUNTED = 10;
    private static final int SAVES = 40;
    private static final int MOST_SECONDS = 60;

    private WatchTimes() {
    }

    /**
     * Measures and prints.
     *
     * @param arguments none
     */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("watch");
        try (VirtualScreen screen = VirtualScreen.start(Files.createDirectory(folder.resolve("screen")))) {
            Files.writeString(folder.resolve("scene.txt"), SCENE);
            ProcessBuilder builder = new ProcessBuilder(MeasuredProcess.program(folder.resolve("scene.txt").toString(),
                folder.resolve("out.png").toString(), "--watch", "--quiet"));
            builder.environment().put("DISPLAY", screen.name());
            Process program = builder.inheritIO().start();
            try {
                System.out.print(Machine.facts() + "\n" + sentence(times(folder)));
            } finally {
                program.destroy();
                program.waitFor();
            }
        } finally {
            MeasuredProcess.delete(folder.resolve("screen"));
            MeasuredProcess.delete(folder);
        }
    }

    private static List<Double> times(Path folder) throws IOException, InterruptedException {
        List<Double> milliseconds = new ArrayList<>();
        awaitPicture(folder, "null");
        for (int i = 0; i < NOT_COUNTED + SAVES; i++) {
            Thread.sleep(300);
            String older = identity(folder);
            Files.writeString(folder.resolve("scene.txt"), SCENE.replace("sph   0 1 0", "sph   0." + i + " 1 0"));
            long saved = System.nanoTime();
            awaitPicture(folder, older);
            if (i >= NOT_COUNTED) {
                milliseconds.add((System.nanoTime() - saved) / 1e6);
            }
        }
        return milliseconds;
    }

    /** Every picture is a new file. */
    private static String identity(Path folder) throws IOException {
        Path file = folder.resolve("out.png");
        return Files.exists(file) ? Files.getLastModifiedTime(file).toString() : "null";
    }

    private static void awaitPicture(Path folder, String older) throws IOException, InterruptedException {
        long begin = System.nanoTime();
        while (identity(folder).equals(older)) {
            if (System.nanoTime() - begin > TimeUnit.SECONDS.toNanos(MOST_SECONDS)) {
                throw new IOException("no picture within " + MOST_SECONDS + " seconds");
            }
            Thread.sleep(1);
        }
    }

    private static String sentence(List<Double> milliseconds) {
        Quantiles times = Quantiles.of(milliseconds);
        return String.format(Locale.ROOT,
            "From the save of README's first scene to its picture of 500 x 500 pixels in the file, "
            + "%d times in the warm virtual machine: %.0f ms (%.0f - %.0f).%n",
            times.count(), times.median(), times.lower(), times.upper());
    }
}
