package raytracing.shade;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.Meshes;
import raytracing.SceneText;
import raytracing.Steps;
import raytracing.ambient.AmbientLight;
import raytracing.math.Vector;
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

    /** Meshes on a floor of triangles, one of glass, one of a mirror and one so fine that it has a hierarchy and a crowd. */
    @ParameterizedTest
    @EnumSource(Shortcut.class)
    void meshesAreTheSameWithoutEachShortcut(Shortcut shortcut) {
        Scene scene = SceneText.scene("""
            cam 0.3 2.5 -6  0.2 0.7 0  0 1 0  1 1
            set 0.3 0.5 0.8  4 4
            mtl 0.7 0.7 0.6  0 0 0  0 0 0  1 0
            mtl 0.3 0.5 0.3  0.4 0.4 0.4  0.1 0.1 0.1  20 0.6
            mtl 0.1 0.1 0.2  0.5 0.5 0.5  0.7 0.7 0.7  50 0
            trg -9 0 -9 9 0 -9 9 0 9  1
            trg -9 0 -9 9 0 9 -9 0 9  1
            lgt 4 6 -4  0.8 0.8 0.7  1 1 2
            lgt -5 3 -3  0.3 0.3 0.4  1 0.8 0.5
            """, Meshes.ball(new Vector(-1, 0.9, 0.5), 0.8, 20, 1), Meshes.hook(new Vector(1.2, 0.7, 0.8), 0.7, 3),
            Meshes.box(new Vector(0.3, 0.4, -1), 0.8, 2));
        assertSamePictures(scene, EnumSet.complementOf(EnumSet.of(shortcut)), SIZE);
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
