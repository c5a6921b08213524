package raytracing.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.SceneText;
import raytracing.compiled.CompiledScene;
import raytracing.compiled.ShadowMode;
import raytracing.compiled.Shortcut;
import raytracing.compiled.Workers;
import raytracing.parse.SceneParser;
import raytracing.progress.Preparation;
import raytracing.progress.Preparation.State;
import raytracing.progress.Preparation.Step;
import raytracing.scene.Scene;
import raytracing.shade.AmbientEstimate;

/** Whoever prepares a scene tells how much there is to do, and does as much. */
class ToldPreparationTest {
    private static final String HEAD = """
        cam 0 1 -3   0 1 0   0 1 0   1 1
        set 0.8 0.9 1   3 4
        mtl 0.5 0.5 0.5   0 0 0   0 0 0   1 0  0.5 0.5 0.5
        mtl 0.5 0.5 0.5   0 0 0   0 0 0   1 0
        """;

    /** Keeps what it is told. */
    private static final class Listening implements Workers {
        private final AtomicLong expected = new AtomicLong();
        private final AtomicLong done = new AtomicLong();
        private final AtomicLong calls = new AtomicLong();

        @Override
        public void doBoth(Runnable first, Runnable second) {
            ALONE.doBoth(first, second);
        }

        @Override
        public void expect(long count) {
            expected.addAndGet(count);
        }

        @Override
        public void advance(long count) {
            done.addAndGet(count);
            calls.incrementAndGet();
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

    private static Listening compile(Scene scene) {
        Listening listening = new Listening();
        new CompiledScene(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT, EnumSet.allOf(Shortcut.class), listening);
        return listening;
    }

    /** After every 4096 lines, and the bytes before them: here each sphere has 16. */
    @Test
    void readingTellsNowAndThen(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("large.txt");
        Files.writeString(file, "sph 1 2 3 0.5 1\n".repeat(10_000) + HEAD);
        Preparation preparation = new Preparation();
        SceneParser.parseFile(file, preparation);
        assertEquals(new State(Step.READING, 16.0 * 8192 / Files.size(file)), preparation.state());
    }

    /** Few surfaces are not arranged; large groups are shared out, and the parts tell. */
    @ParameterizedTest(name = "{0} spheres, {1} boxes")
    @CsvSource({"40, 47, 0", "48, 0, 48", "30, 100, 100", "500, 60, 560", "65537, 48, 65585"})
    void everyBodyOfAHierarchyIsExpectedAndArrangedOnce(int spheres, int boxes, long bodies) {
        Listening listening = compile(scene(spheres, boxes));
        assertEquals(bodies, listening.expected.get());
        assertEquals(bodies, listening.done.get());
    }

    @Test
    void manyBodiesAreToldInParts() {
        Listening listening = compile(scene(140_000, 0));
        assertEquals(140_000, listening.done.get());
        assertTrue(listening.calls.get() > 2, "calls: " + listening.calls);
    }

    /** Of a picture with a grid of 40 x 40 places, all are settled; where nothing is seen, a finer grid has 160 x 160. */
    @ParameterizedTest(name = "a ball of {0}")
    @CsvSource({"1, 1600", "0.015, 25600"})
    void everyPlaceOfAmbientLightIsSettledOnce(double radius, long places) {
        Scene scene = SceneText.scene(HEAD, "sph 0.0031 1.0043 0 " + radius + " 1", "lgt 3 9 -9  1 1 1  1 1 1");
        Listening listening = new Listening();
        AmbientEstimate.of(scene, new CompiledScene(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT), 100, 100, 1,
            listening);
        assertEquals(places, listening.expected.get());
        assertEquals(places, listening.done.get());
        assertTrue(listening.calls.get() > 3, "calls: " + listening.calls);
    }

    @Test
    void aRendererTellsItsSteps() {
        Preparation preparation = new Preparation();
        new Renderer(SceneText.scene(HEAD, "sph 0 1 0 1 1"), RenderSettings.DEFAULT.withSize(40, 40), preparation);
        assertEquals(new State(Step.AMBIENT_LIGHT, 1), preparation.state());
    }

    @Test
    void aSceneThatCannotBeArrangedStopsAtThatStep() {
        Preparation preparation = new Preparation();
        Scene broken = new Scene(scene(1, 1).camera(), scene(1, 1).settings(), List.of(), scene(1, 1).surfaces(),
            List.of());
        assertThrows(RuntimeException.class,
            () -> new Renderer(broken, RenderSettings.DEFAULT.withSize(4, 4), preparation));
        assertEquals(Step.ARRANGING, preparation.state().step());
    }
}
