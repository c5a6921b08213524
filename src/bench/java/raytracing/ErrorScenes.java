package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import raytracing.parse.RayTracerException;
import raytracing.render.ErrorLimit;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Renderers;
import raytracing.scene.Scene;
import raytracing.shadow.ShadowMethod;

/** The scenes whose errors under {@code --error} are measured: those in {@code scenes/} and the course's. */
final class ErrorScenes {
    private ErrorScenes() {
    }

    /** A scene with the name that tables give it. */
    record Named(String title, Scene scene) {
        private static Named of(Path file) throws IOException, RayTracerException {
            return new Named(file.getFileName().toString().replace(".txt", ""), Steps.parseScene(file));
        }

        boolean hasAmbientLight() {
            return scene.materials().stream().anyMatch(material -> !material.ambient().isBlack());
        }
    }

    /** All that are there: ours, then the course's. */
    static List<Named> all() throws IOException, RayTracerException {
        List<Named> scenes = new ArrayList<>();
        for (Path file : SceneFiles.all().toList()) {
            scenes.add(Named.of(file));
        }
        for (Path file : courseFiles()) {
            scenes.add(Named.of(file));
        }
        return scenes;
    }

    private static List<Path> courseFiles() throws IOException {
        if (!Files.isDirectory(Shared.SCENES)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(Shared.SCENES)) {
            return files.filter(file -> file.toString().endsWith(".txt")).sorted().toList();
        }
    }

    /** A sentence if the course's scenes are missing, on standard error too; otherwise nothing. */
    static String missing() throws IOException {
        if (!courseFiles().isEmpty()) {
            return "";
        }
        String sentence = "The course's scenes are not beside the checkout and are not measured.\n";
        System.err.print("SKIPPED: " + sentence);
        return sentence;
    }

    /** A scene that is prepared as {@code --error} prepares it for the smallest limit that is measured. */
    static Renderer prepared(Scene scene, int size, ShadowMethod shadows, double leastLimit) {
        return Renderers.of(scene, RenderSettings.DEFAULT.withSize(size, size).withShadowMethod(shadows)
            .withSampling(new ErrorLimit(leastLimit)));
    }
}
