package raytracing;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import raytracing.ambient.AmbientLight;
import raytracing.parse.RayTracerException;
import raytracing.program.Command;
import raytracing.program.CommandLine;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Renderers;

/** The pictures of the scenes folder, all drawn with the same options, and those of AMBIENT.md. */
final class ScenePictures {
    /** What stands after SCENE and OUTPUT on the command line; README has it too. */
    static final String OPTIONS = "--samples 4 --shadows exact";

    private static final Path WITHOUT_AMBIENT_LIGHT = Path.of("src", "docs", "ambient");

    private ScenePictures() {
    }

    /** Where the picture of a scene lies. */
    static Path pictureOf(Path scene) {
        return scene.resolveSibling(name(scene) + ".png");
    }

    /** Where AMBIENT.md's picture of a scene without ambient light lies. */
    static Path pictureWithoutAmbientLight(Path scene) {
        return WITHOUT_AMBIENT_LIGHT.resolve(name(scene) + "_without.png");
    }

    /** The scenes of which AMBIENT.md shows pictures without ambient light. */
    static List<Path> drawnWithoutAmbientLight() throws IOException {
        return SceneFiles.all().filter(scene -> List.of("arcade", "studio").contains(name(scene))).toList();
    }

    /** How all these pictures are drawn. */
    static RenderSettings settings() throws RayTracerException {
        return ((Command.Draw) CommandLine.parse(words(Path.of("any.txt")))).settings();
    }

    private static String name(Path scene) {
        return scene.getFileName().toString().replace(".txt", "");
    }

    private static String[] words(Path scene) {
        List<String> words = new ArrayList<>(List.of(scene.toString(), pictureOf(scene).toString()));
        words.addAll(List.of(OPTIONS.split(" ")));
        return words.toArray(String[]::new);
    }

    /**
     * Draws all of them anew: those of the scenes folder by the jar, as a user would.
     *
     * @param arguments none
     */
    public static void main(String[] arguments) throws Exception {
        for (Path scene : SceneFiles.all().toList()) {
            Program program = Program.run(Path.of("."), words(scene));
            System.out.print(program.errors());
            if (program.status() != 0) {
                System.exit(program.status());
            }
        }
        for (Path scene : drawnWithoutAmbientLight()) {
            Renderer renderer = Renderers.of(Steps.parseScene(scene), settings());
            BufferedImage picture = Renderers.film(Renderers.inAmbientLight(renderer, AmbientLight.NONE)).toImage();
            ImageIO.write(picture, "png", pictureWithoutAmbientLight(scene).toFile());
        }
    }
}
