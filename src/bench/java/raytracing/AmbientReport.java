package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import raytracing.parse.RayTracerException;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.shade.AmbientLight;

/** Writes into AMBIENT.md and README.md what estimates of ambient light are worth, and draws scenes without it. */
public final class AmbientReport {
    private static final Path DOCUMENT = Path.of("src", "docs", "AMBIENT.md");
    private static final Path README = Path.of("README.md");
    private static final Path PICTURES = Path.of("src", "docs", "ambient");

    private AmbientReport() {
    }

    /**
     * Measures, draws and writes.
     *
     * @param arguments {@code quick} for fewer rays and runs
     */
    public static void main(String[] arguments) throws IOException, RayTracerException {
        boolean isQuick = List.of(arguments).contains("quick");
        Effort effort = isQuick ? Effort.QUICK : Effort.FULL;
        Path folder = Files.createTempDirectory("ambient");
        try {
            String origin = Machine.origin("gradle ambient" + (isQuick ? " -Pquick" : "")) + " " + AmbientRoom.missing();
            String summary = AmbientErrors.summary(effort);
            MeasuredPart.replace(DOCUMENT, origin + "\n### Errors\n\n" + AmbientErrors.section(effort)
                + "\n### Times\n\n" + AmbientTimes.section(effort, folder));
            MeasuredPart.replace(README, summary + "\n" + origin);
        } finally {
            MeasuredProcess.delete(folder);
        }
        drawWithoutAmbientLight("arcade");
        drawWithoutAmbientLight("studio");
    }

    private static void drawWithoutAmbientLight(String name) throws IOException, RayTracerException {
        Renderer renderer = new Renderer(RayTracer.parseScene(Path.of("scenes", name + ".txt")), RenderSettings.DEFAULT);
        ImageIO.write(renderer.inAmbientLight(AmbientLight.NONE).render().toImage(), "png",
            PICTURES.resolve(name + "_without.png").toFile());
    }
}
