package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.film.ImageFormat;
import raytracing.parallel.ForkJoin;
import raytracing.parse.ParsedScene;
import raytracing.parse.SceneParser;
import raytracing.program.Messages;
import raytracing.render.Cancellation;
import raytracing.render.Drawing;
import raytracing.render.DrawingListener;
import raytracing.render.RenderSettings;
import raytracing.render.Renderers;

/** Scenes without a likely mistake get no warning, neither when they are read nor at the end. */
class ScenesWithoutWarningsTest {
    private static final RenderSettings SMALL = RenderSettings.DEFAULT.withSize(16, 16);
    static Stream<Path> ours() throws IOException {
        return SceneFiles.all();
    }

    @ParameterizedTest
    @MethodSource("ours")
    void ourScenes(Path file) throws Exception {
        assertNoWarnings(file);
    }

    @Test
    void theCoursesScenes() throws Exception {
        Shared.require(Shared.SCENES);
        try (Stream<Path> files = Files.list(Shared.SCENES)) {
            for (Path file : files.filter(file -> file.toString().endsWith(".txt")).sorted().toList()) {
                assertNoWarnings(file);
            }
        }
    }

    private static void assertNoWarnings(Path file) throws Exception {
        ParsedScene parsed = SceneParser.parseFile(file, ForkJoin.sequential());
        assertEquals(List.of(), parsed.warnings());
        Drawing drawing = new Drawing(Renderers.of(parsed.scene(), SMALL), new Cancellation(),
            Cancellation.Leftovers.DISCARD, DrawingListener.NONE);
        drawing.band(0);
        assertFalse(new Messages("out.png", ImageFormat.PNG, SMALL).isOfNothing(drawing), file.toString());
    }
}
