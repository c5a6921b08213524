package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.render.RenderSettings;

/** The pictures in the scenes folder are what this program draws today; {@code gradle scenes} redraws them. */
public class CommittedScenesTest {
    public static Stream<Path> scenes() throws IOException {
        return SceneFiles.all();
    }

    private static List<String> names(Stream<Path> files, String ending) {
        return files.map(file -> file.getFileName().toString().replace(ending, "")).collect(Collectors.toList());
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void everyPictureIsWhatItsSceneDraws(Path scene) throws Exception {
        BufferedImage drawn =
            RayTracer.renderScene(RayTracer.parseScene(scene), RenderSettings.DEFAULT).toImage();
        BufferedImage committed = ImageIO.read(new java.io.File(scene.toString().replace(".txt", ".png")));
        PictureDifference difference = new PictureDifference(drawn, committed);
        assertEquals(0, difference.shareOffByMoreThan(0), difference::toString);
    }

    @Test
    void everySceneHasItsPictureAndEveryPictureItsScene() throws IOException {
        assertEquals(names(SceneFiles.endingIn(".txt"), ".txt"), names(SceneFiles.endingIn(".png"), ".png"));
        assertTrue(scenes().count() >= 8);
    }
}
