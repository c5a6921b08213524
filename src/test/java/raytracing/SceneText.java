package raytracing;

import java.nio.charset.StandardCharsets;
import raytracing.parallel.ForkJoin;
import raytracing.parse.RayTracerException;
import raytracing.parse.SceneParser;
import raytracing.scene.Scene;

/** Scenes for tests, written as users write them. */
public final class SceneText {
    private SceneText() {
    }

    /** The scene of these lines, which must be right. */
    public static Scene scene(String... lines) {
        try {
            return SceneParser.parse("test scene", String.join("\n", lines).getBytes(StandardCharsets.UTF_8),
                ForkJoin.sequential()).scene();
        } catch (RayTracerException wrong) {
            throw new AssertionError(wrong.getMessage(), wrong);
        }
    }
}
