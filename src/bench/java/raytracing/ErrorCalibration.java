package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import raytracing.parse.RayTracerException;
import raytracing.render.ErrorCheck;
import raytracing.render.OrdinaryScene;
import raytracing.render.Renderer;
import raytracing.render.TrueLight;
import raytracing.scene.Scene;
import raytracing.shadow.ShadowMethod;
import raytracing.timed.SceneLines;

/** What {@code --error E} promises beside what it keeps. */
final class ErrorCalibration {
    private static final int SIZE = 40;
    private static final List<Double> LIMITS = List.of(4.0, 2.0, 1.0, 0.5);
    private static final double LEAST = 0.5;
    private static final Path FAILED = Path.of("build", "errors");
    private static final List<String> FIGURES = List.of("E", "pixels", "rays each", "true RMS", "printed", "printed / true",
        "beyond 2 E, %", "beyond 4 E, %");

    /** What is left of all scenes of a kind. */
    private static final class Pool {
        private final String title;
        private final List<ErrorCheck> checks = LIMITS.stream().map(ErrorCheck::new).toList();
        private final int[] failed = new int[LIMITS.size()];
        private int scenes;

        Pool(String title) {
            this.title = title;
        }

        List<List<String>> rows() {
            List<List<String>> rows = new ArrayList<>();
            for (int i = 0; i < LIMITS.size(); i++) {
                List<String> row = cells(title, checks.get(i));
                row.add(failed[i] + " of " + scenes);
                rows.add(row);
            }
            return rows;
        }
    }

    private final int points;
    private final int randomScenes;
    private final int sampledScenes;
    private final List<List<String>> rows = new ArrayList<>();

    private ErrorCalibration(Effort effort) {
        boolean isFull = effort == Effort.FULL;
        points = isFull ? 4096 : 1024;
        randomScenes = 200;
        sampledScenes = randomScenes / 10;
    }

    static String section(Effort effort) throws IOException, RayTracerException {
        return new ErrorCalibration(effort).measured();
    }

    private String measured() throws IOException, RayTracerException {
        Files.createDirectories(FAILED);
        List<Pool> pools = List.of(named(), random("random", randomScenes, new ShadowMethod.Exact()),
            random("random, sampled shadows", sampledScenes, ShadowMethod.OF_THE_SCENE));
        List<List<String>> pooled = pools.stream().flatMap(pool -> pool.rows().stream()).toList();
        return String.format(Locale.ROOT, """
            %d x %d pixels, exact shadows unless another kind is named. The truth is the mean of %,d points of another seed
            in each pixel; its own variance is subtracted. The same ambient light is in both. Counted are the pixels whose
            points are not all equal to half a step. The bounds: true RMS at most E, at most 2 %% of the pixels beyond 2 E,
            at most 0.1 %% beyond 4 E, and what is printed between 0.5 and 2 times the true RMS. The random scenes are
            ordinary ones: a floor, 3 to 30 balls and cubes, specks, mirrors, glass, 1 to 3 lights.

            """, SIZE, SIZE, points) + verdict(pooled) + "\n"
            + MarkdownTable.of(heads("scenes", "fails alone"), pooled)
            + "\n" + verdict(rows) + "\n"
            + MarkdownTable.of(heads("scene"), rows);
    }

    private static List<String> heads(String first, String... last) {
        List<String> heads = new ArrayList<>(List.of(first));
        heads.addAll(FIGURES);
        heads.add("does not hold");
        heads.addAll(List.of(last));
        return heads;
    }

    private static String verdict(List<List<String>> table) {
        int column = FIGURES.size() + 1;
        long failing = table.stream().filter(row -> !row.get(column).equals("-")).count();
        return failing == 0 ? "All bounds hold in each of these " + table.size() + " rows.\n"
            : "Some bound does not hold in " + failing + " of these " + table.size() + " rows.\n";
    }

    private Pool named() throws IOException, RayTracerException {
        Pool pool = new Pool("ours and the course's");
        for (ErrorScenes.Named named : ErrorScenes.all()) {
            for (ErrorCheck check : add(named.title(), named.scene(), new ShadowMethod.Exact(), pool)) {
                rows.add(cells(named.title(), check));
            }
        }
        return pool;
    }

    private Pool random(String title, int count, ShadowMethod shadows) throws IOException {
        Pool pool = new Pool(title);
        for (int seed = 0; seed < count; seed++) {
            Scene scene = OrdinaryScene.of(seed);
            List<ErrorCheck> checks = add(title + " " + seed, scene, shadows, pool);
            if (checks.stream().anyMatch(check -> !check.failures().isEmpty())) {
                Files.writeString(FAILED.resolve(String.format(Locale.ROOT, "random-%03d.txt", seed)), SceneLines.of(scene));
            }
        }
        return pool;
    }

    /** The truth is found once for all limits. Says at once what does not hold, and where. */
    private List<ErrorCheck> add(String title, Scene scene, ShadowMethod shadows, Pool pool) {
        Renderer renderer = ErrorScenes.prepared(scene, SIZE, shadows, LEAST);
        TrueLight truth = TrueLight.of(renderer, points, TrueLight.Choice.ALL);
        List<ErrorCheck> checks = new ArrayList<>();
        for (int i = 0; i < LIMITS.size(); i++) {
            ErrorCheck check = new ErrorCheck(LIMITS.get(i));
            List<ErrorCheck.Outlier> outliers = check.add(renderer, truth);
            System.out.println(title + ", " + check);
            if (!check.failures().isEmpty()) {
                pool.failed[i]++;
                outliers.forEach(outlier -> System.out.println("    " + outlier.replay()));
            }
            pool.checks.get(i).add(check);
            checks.add(check);
        }
        pool.scenes++;
        return checks;
    }

    private static List<String> cells(String title, ErrorCheck check) {
        return new ArrayList<>(List.of(title, figure(1, check.limit()), String.valueOf(check.pixels()),
            figure(1, check.raysEach()), figure(2, check.trueError()), figure(2, check.printedError()),
            figure(2, check.printedOverTrue()), figure(2, 100 * check.shareBeyondTwice()),
            figure(3, 100 * check.shareBeyondFourTimes()),
            check.failures().isEmpty() ? "-" : String.join(", ", check.failures())));
    }

    private static String figure(int decimals, double value) {
        return String.format(Locale.ROOT, "%." + decimals + "f", value);
    }
}
