package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.ambient.AmbientLight;
import raytracing.render.Region;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Renderers;

/**
 * The pictures in the scenes folder are what this program draws today. Held are bands of rows, a tenth of each picture, to
 * save time; {@code gradle scenes} redraws all of them, and then git says whether any differs.
 */
public class CommittedScenesTest {
    private static final int ROWS = 10;
    private static final int FIRST_ROW = 45;
    private static final int BETWEEN_BANDS = 100;

    public static Stream<Path> scenes() throws IOException {
        return SceneFiles.all();
    }

    static Stream<Path> scenesWithoutAmbientLight() throws IOException {
        return ScenePictures.drawnWithoutAmbientLight().stream();
    }

    private static List<String> names(Stream<Path> files, String ending) {
        return files.map(file -> file.getFileName().toString().replace(ending, "")).collect(Collectors.toList());
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void everyPictureIsWhatItsSceneDraws(Path scene) throws Exception {
        assertPictureIsDrawn(ScenePictures.pictureOf(scene), scene, UnaryOperator.identity());
    }

    @ParameterizedTest
    @MethodSource("scenesWithoutAmbientLight")
    void picturesWithoutAmbientLightAreWhatTheirScenesDraw(Path scene) throws Exception {
        assertPictureIsDrawn(ScenePictures.pictureWithoutAmbientLight(scene), scene,
            renderer -> Renderers.inAmbientLight(renderer, AmbientLight.NONE));
    }

    private static void assertPictureIsDrawn(Path picture, Path scene, UnaryOperator<Renderer> light) throws Exception {
        RenderSettings settings = ScenePictures.settings();
        BufferedImage committed = ImageIO.read(picture.toFile());
        assertEquals(settings.width(), committed.getWidth());
        assertEquals(settings.height(), committed.getHeight());
        for (int top = FIRST_ROW; top < settings.height(); top += BETWEEN_BANDS) {
            Region band = new Region(0, top, settings.width(), top + ROWS);
            Renderer renderer = Renderers.of(Steps.parseScene(scene), settings.withRegion(band));
            BufferedImage drawn = Renderers.film(light.apply(renderer)).toImage();
            PictureDifference difference =
                new PictureDifference(drawn, committed.getSubimage(0, top, settings.width(), ROWS));
            assertEquals(0, difference.shareOffByMoreThan(0), () -> band + ": " + difference);
        }
    }

    @Test
    void everySceneHasItsPictureAndEveryPictureItsScene() throws IOException {
        assertEquals(names(SceneFiles.endingIn(".txt"), ".txt"), names(SceneFiles.endingIn(".png"), ".png"));
        assertTrue(scenes().count() >= 8);
    }

    @Test
    void theReadmeHasTheCommandThatDrawsThem() throws IOException {
        assertTrue(Files.readString(Path.of("README.md")).contains(
            "java -jar build/libs/RayTracer.jar scenes/NAME.txt scenes/NAME.png " + ScenePictures.OPTIONS + "\n"));
    }
}
