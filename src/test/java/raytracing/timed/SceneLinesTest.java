package raytracing.timed;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.SceneText;
import raytracing.Steps;
import raytracing.scene.Scene;

class SceneLinesTest {
    @ParameterizedTest
    @MethodSource("raytracing.CommittedScenesTest#scenes")
    void whatIsWrittenIsReadAsTheSameScene(Path file) throws Exception {
        Scene scene = Steps.parseScene(file);
        assertEquals(scene, SceneText.scene(SceneLines.of(scene)));
    }

    static Stream<Scene> madeScenes() {
        return Stream.of(Sphereflake.scene(3, 3), Nest.scene(), Hall.scene());
    }

    @ParameterizedTest
    @MethodSource("madeScenes")
    void madeScenesAreScenesThatAFileCanHold(Scene scene) {
        assertEquals(scene, SceneText.scene(SceneLines.of(scene)));
    }

    @Test
    void numbersOfMadeScenesHaveNineDigits() {
        assertEquals(List.of(0.333333333, 0.666666667, 123456789000.0, 0.0),
            Stream.of(1.0 / 3, 2.0 / 3, 123456789012.4, -0.0).map(NineDigits::of).toList());
    }
}
