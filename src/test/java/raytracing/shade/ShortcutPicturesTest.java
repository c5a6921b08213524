package raytracing.shade;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.Steps;
import raytracing.ambient.AmbientLight;
import raytracing.parallel.ForkJoin;
import raytracing.scene.CameraRays;
import raytracing.scene.Scene;
import raytracing.shadow.ShadowMethod;
import raytracing.timed.Nest;
import raytracing.timed.Sphereflake;
import raytracing.shadow.ShadowMethod;
import raytracing.trace.PreparedScene;
import raytracing.trace.ShadowMode;
import raytracing.trace.Shortcut;

/** Whole pictures with and without the shortcuts: the same light in every pixel, to the last bit. */
class ShortcutPicturesTest {
    private static final int SIZE = 48;
    private static final Set<Shortcut> NONE = EnumSet.noneOf(Shortcut.class);

    @ParameterizedTest
    @MethodSource("raytracing.CommittedScenesTest#scenes")
    void committedScenesAreTheSameWithoutShortcuts(Path file) throws Exception {
        assertSamePictures(Steps.parseScene(file), NONE, SIZE);
    }

    @ParameterizedTest
    @EnumSource(Shortcut.class)
    void theSphereflakeIsTheSameWithoutEachShortcut(Shortcut shortcut) {
        assertSamePictures(Sphereflake.scene(3, 2), EnumSet.complementOf(EnumSet.of(shortcut)), SIZE);
    }

    @Test
    void theNestIsTheSameWithoutShortcuts() {
        assertSamePictures(Nest.scene(), NONE, 24);
    }

    private static void assertSamePictures(Scene scene, Set<Shortcut> some, int size) {
        for (ShadowMode mode : ShadowMode.values()) {
            assertSamePictures(scene, mode, ShadowMethod.OF_THE_SCENE, some, size);
        }
        assertSamePictures(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT, new ShadowMethod.Exact(), some, size);
    }

    private static void assertSamePictures(Scene scene, ShadowMode mode, ShadowMethod method, Set<Shortcut> some,
                                           int size) {
        Shader all = shader(scene, mode, method, EnumSet.allOf(Shortcut.class));
        Shader fewer = shader(scene, mode, method, some);
        CameraRays rays = new CameraRays(scene.camera(), size, size);
        for (int y = 0; y < size; y++) {
            for (int x = 0; x < size; x++) {
                long key = (long) y * size + x;
                assertEquals(fewer.light(rays, x + 0.5, y + 0.5, key).toColor(),
                    all.light(rays, x + 0.5, y + 0.5, key).toColor(), "pixel " + x + ", " + y);
            }
        }
    }

    private static Shader shader(Scene scene, ShadowMode mode, ShadowMethod method, Set<Shortcut> shortcuts) {
        return new Shader(scene, new PreparedScene(scene, mode, shortcuts, ForkJoin.sequential()), method, AmbientLight.NONE);
    }
}
