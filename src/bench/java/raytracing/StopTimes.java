package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/** From a signal at a random moment to the end of the process. */
final class StopTimes {
    /** Each pixel of the first takes some microseconds, of the second about a second. */
    private static final String QUICK_PIXELS = "set 0.2 0.3 0.4  5 4";
    private static final String SLOW_PIXELS = "set 0.2 0.3 0.4  1024 4";
    private static final String SCENE = """
        cam 0 1 -3   0 0 0   0 1 0   1 1
        mtl 0.5 0.5 0.5   0 0 0   0 0 0   1 0
        pln 0 1 0  0  1
        sph 0 0.5 0  0.5  1
        lgt 0 9 0   1 1 1   1 1 20
        lgt 5 9 0   1 1 1   1 1 20
        """;
    private static final String SIZE = "12000";
    private static final int FEWEST_MILLISECONDS = 600;
    private static final int MORE_MILLISECONDS = 1500;

    private StopTimes() {
    }

    static String section(int runs, Path folder) throws IOException {
        List<List<String>> rows = new ArrayList<>();
        rows.add(row("SIGTERM, quick pixels", QUICK_PIXELS, runs, folder));
        rows.add(row("SIGTERM, slow pixels", SLOW_PIXELS, runs, folder));
        rows.add(row("SIGTERM, quick pixels, `--keep-partial`", QUICK_PIXELS, runs, folder, "--keep-partial"));
        return MarkdownTable.of(List.of("", "runs", "median", "largest"), rows)
            + "\nAt random moments from 0.6 to 2.1 s after the start of a picture of " + SIZE + " x " + SIZE + " pixels ("
            + "2000 x 2000 with `--keep-partial`, which encodes and writes a picture of that size before the end). SIGINT goes the same way.\n";
    }

    private static List<String> row(String name, String settings, int runs, Path folder, String... options)
            throws IOException {
        Path scene = Files.writeString(folder.resolve("scene.txt"), settings + "\n" + SCENE);
        Random random = new Random(1);
        List<Double> milliseconds = new ArrayList<>();
        String size = options.length == 0 ? SIZE : "2000";
        for (int i = 0; i < runs; i++) {
            List<String> command = new ArrayList<>(MeasuredProcess.program(scene.toString(),
                folder.resolve("out.png").toString(), size, size));
            Collections.addAll(command, options);
            milliseconds.add(timeToEnd(command, FEWEST_MILLISECONDS + random.nextInt(MORE_MILLISECONDS)));
        }
        return List.of(name, String.valueOf(runs), format(Quantiles.of(milliseconds).median()),
            format(Collections.max(milliseconds)));
    }

    private static String format(double milliseconds) {
        return String.format(Locale.ROOT, "%.0f", milliseconds);
    }

    private static double timeToEnd(List<String> command, long delay) throws IOException {
        Process process = new ProcessBuilder(command).redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD).start();
        try {
            Thread.sleep(delay);
            if (!process.isAlive()) {
                throw new IOException("ended before it was stopped: " + String.join(" ", command));
            }
            long start = System.nanoTime();
            process.destroy();
            process.waitFor();
            return (System.nanoTime() - start) / 1e6;
        } catch (InterruptedException request) {
            throw new IOException("interrupted: " + String.join(" ", command), request);
        }
    }
}
