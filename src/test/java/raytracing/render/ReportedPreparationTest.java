package raytracing.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.SceneText;
import raytracing.estimate.AmbientEstimate;
import raytracing.parallel.ForkJoin;
import raytracing.parallel.Preparation.State;
import raytracing.parallel.Preparation.Step;
import raytracing.parallel.Preparation;
import raytracing.parse.SceneParser;
import raytracing.scene.Scene;
import raytracing.trace.PreparedScene;
import raytracing.trace.Queries;
import raytracing.trace.ShadowMode;
import raytracing.trace.Shortcut;

/** The preparation of a scene reports how much there is to do, and does as much. */
class ReportedPreparationTest {
    private static final String HEAD = """
        cam 0 1 -3   0 1 0   0 1 0   1 1
        set 0.8 0.9 1   3 4
        mtl 0.5 0.5 0.5   0 0 0   0 0 0   1 0  0.5 0.5 0.5
        mtl 0.5 0.5 0.5   0 0 0   0 0 0   1 0
        """;

    /** Counts the reports and adds them up. */
    private static final class Counting extends Preparation {
        private long expected;
        private long done;
        private long calls;

        @Override
        public synchronized void expect(long count) {
            expected += count;
        }

        @Override
        public synchronized void advance(long count) {
            done += count;
            calls++;
        }
    }

    private static Scene scene(int spheres, int boxes) {
        StringBuilder lines = new StringBuilder(HEAD).append("pln 0 1 0  0  2\n");
        for (int i = 0; i < spheres; i++) {
            lines.append("sph ").append(i % 97).append(' ').append(i % 89).append(' ').append(i % 83).append(" 0.4 2\n");
        }
        for (int i = 0; i < boxes; i++) {
            lines.append("box ").append(i % 97).append(' ').append(i % 89).append(' ').append(-i).append(" 0.4 2\n");
        }
        return SceneText.scene(lines.toString());
    }

    private static Counting prepare(Scene scene) {
        Counting counted = new Counting();
        new PreparedScene(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT, EnumSet.allOf(Shortcut.class),
            new ForkJoin(1, counted));
        return counted;
    }

    /** After every 4096 lines, and the bytes before them: here each sphere has 16. */
    @Test
    void readingReportsNowAndThen(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("large.txt");
        Files.writeString(file, "sph 1 2 3 0.5 1\n".repeat(10_000) + HEAD);
        Preparation preparation = new Preparation();
        SceneParser.parseFile(file, new ForkJoin(1, preparation));
        assertEquals(new State(Step.READING, 16.0 * 8192 / Files.size(file)), preparation.state());
    }

    /** Few surfaces are not arranged; large groups are shared out, and the parts report. */
    @ParameterizedTest(name = "{0} spheres, {1} boxes")
    @CsvSource({"40, 47, 0", "48, 0, 48", "30, 100, 100", "500, 60, 560", "65537, 48, 65585"})
    void everyBodyOfAHierarchyIsExpectedAndArrangedOnce(int spheres, int boxes, long bodies) {
        Counting counted = prepare(scene(spheres, boxes));
        assertEquals(bodies, counted.expected);
        assertEquals(bodies, counted.done);
    }

    @Test
    void manyBodiesAreReportedInParts() {
        Counting counted = prepare(scene(140_000, 0));
        assertEquals(140_000, counted.done);
        assertTrue(counted.calls > 2, "calls: " + counted.calls);
    }

    /** Of a picture with a grid of 80 x 80 places, all are settled; where nothing is seen, a finer grid has 160 x 160. */
    @ParameterizedTest(name = "a ball of {0}")
    @CsvSource({"1, 6400", "0.015, 25600"})
    void everyPlaceOfAmbientLightIsSettledOnce(double radius, long places) {
        Scene scene = SceneText.scene(HEAD, "sph 0.0031 1.0043 0 " + radius + " 1", "lgt 3 9 -9  1 1 1  1 1 1");
        Counting counted = new Counting();
        AmbientEstimate.of(scene, Queries.prepared(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT), 100, 100, 1,
            Double.POSITIVE_INFINITY, new ForkJoin(1, counted));
        assertEquals(places, counted.expected);
        assertEquals(places, counted.done);
        assertTrue(counted.calls > 3, "calls: " + counted.calls);
    }

    @Test
    void aRendererReportsItsSteps() {
        Preparation preparation = new Preparation();
        Renderer.of(SceneText.scene(HEAD, "sph 0 1 0 1 1"), RenderSettings.DEFAULT.withSize(40, 40), preparation);
        assertEquals(new State(Step.AMBIENT_LIGHT, 1), preparation.state());
    }

    @Test
    void aSceneThatCannotBeArrangedStopsAtThatStep() {
        Preparation preparation = new Preparation();
        Scene broken = new Scene(scene(1, 1).camera(), scene(1, 1).settings(), List.of(), scene(1, 1).surfaces(),
            List.of());
        assertThrows(RuntimeException.class,
            () -> Renderer.of(broken, RenderSettings.DEFAULT.withSize(4, 4), preparation));
        assertEquals(Step.ARRANGING, preparation.state().step());
    }
}
