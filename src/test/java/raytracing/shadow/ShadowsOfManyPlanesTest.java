package raytracing.shadow;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.SceneText;
import raytracing.math.Vector;
import raytracing.parallel.ForkJoin;
import raytracing.scene.Light;
import raytracing.scene.Scene;
import raytracing.surface.Departure;
import raytracing.surface.Hit;
import raytracing.surface.HitRecord;
import raytracing.trace.PreparedScene;
import raytracing.trace.Shortcut;
import raytracing.trace.ShadowMode;

/** Shadows of planes that are asked in groups, beside those of the same planes asked one by one. */
class ShadowsOfManyPlanesTest {
    private static final int POINTS = 300;

    static List<ShadowMethod> methods() {
        return List.of(ShadowMethod.Sampled.withRoot(1), ShadowMethod.Sampled.withRoot(3), new ShadowMethod.Exact());
    }

    /** Most of the planes are glass, and cut the way to the light or the light itself. */
    private static Scene scene(Random random) {
        StringBuilder lines = new StringBuilder("""
            cam 0 0 -5 0 0 0 0 1 0 1 1
            set 0 0 0 1 1
            mtl 1 1 1 0 0 0 0 0 0 1 0
            mtl 1 1 1 0 0 0 0 0 0 1 0.9
            lgt 0 4 0 1 1 1 1 1 2
            pln 0 1 0 0 2
            """);
        for (int i = 0; i < 100; i++) {
            lines.append("pln ").append(random.nextGaussian()).append(' ').append(random.nextGaussian()).append(' ')
                .append(random.nextGaussian()).append(' ').append(4 + 4 * random.nextGaussian()).append(' ')
                .append(i % 20 == 0 ? 1 : 2).append('\n');
        }
        return SceneText.scene(lines.toString());
    }

    private static SoftShadows shadows(ShadowMethod method, Scene scene, EnumSet<Shortcut> shortcuts) {
        return method.shadows(
            new PreparedScene(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT, shortcuts, ForkJoin.sequential()), 1, 1);
    }

    @ParameterizedTest
    @MethodSource("methods")
    void theSameShareArrivesByAsManyRays(ShadowMethod method) {
        Random random = new Random(9);
        Scene scene = scene(random);
        Light light = scene.lights().get(0);
        SoftShadows oneByOne = shadows(method, scene, EnumSet.complementOf(EnumSet.of(Shortcut.HIERARCHY)));
        SoftShadows inGroups = shadows(method, scene, EnumSet.allOf(Shortcut.class));
        int partly = 0;
        for (int i = 0; i < POINTS; i++) {
            Vector point = new Vector(random.nextGaussian(), 0, random.nextGaussian());
            Hit hit = new HitRecord(0, 1, point, 0x1p-48, new Vector(0, 1, 0), Departure.OUTWARD).toHit();
            double share = inGroups.arrivingShare(hit, light, 0, 0x1p-48, i);
            assertEquals(oneByOne.arrivingShare(hit, light, 0, 0x1p-48, i), share);
            partly += share > 0 && share < 1 ? 1 : 0;
        }
        assertEquals(oneByOne.rays(), inGroups.rays());
        assertTrue(partly > POINTS / 10, partly + " points in part of the light");
    }
}
