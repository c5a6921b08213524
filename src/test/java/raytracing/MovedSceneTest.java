package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.DoubleStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.render.RenderSettings;
import raytracing.scene.Scene;
import raytracing.scene.Settings;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

/**
 * The picture does not depend on the place of the scene: moved a million times its own size away from the world's origin,
 * a scene looks the same. Its size is its largest coordinate, but for those of lamps, many of which stand for the sun; the
 * shift is that size, rounded up to a power of two, times 2^20 along every axis.
 *
 * <p>Moving a scene rounds its numbers to the coarse grid that doubles have out there, and that alone may open joints
 * and shift edges. So the scene that stays is the moved one, moved back, which rounds nothing: the two are the same to
 * the last bit but for their place, and whatever differs in the pictures is the renderer's. Normals are rounded to
 * floats first: three products of floats with a power of two add up without rounding, so the offsets of planes are the
 * same too.
 *
 * <p>One shadow ray for each light: its hard edge hides no noise.
 */
class MovedSceneTest {
    private static final RenderSettings SMALL = RenderSettings.DEFAULT.withSize(120, 120);

    /** 60 dB: of the 14400 pixels, one may differ by 30 of 255 steps in all channels, or 14 by 8. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("raytracing.CommittedScenesTest#scenes")
    void aMillionSizesAwayAScenesPictureIsTheSame(Path file) throws Exception {
        Scene scene = withHardShadowsAndShortNormals(Steps.parseScene(file));
        double shift = 0x1p20 * powerOfTwoAbove(size(scene));
        Vector there = new Vector(shift, -shift, shift);
        Scene moved = Motion.by(there).moved(scene);
        Scene unmoved = Motion.by(Vectors.negated(there)).moved(moved);
        assertEquals(moved, Motion.by(there).moved(unmoved), "the two scenes differ by more than their place");
        PictureDifference difference = new PictureDifference(
            Steps.renderScene(moved, SMALL).toImage(), Steps.renderScene(unmoved, SMALL).toImage());
        assertTrue(difference.psnr() >= 60, difference::toString);
    }

    private static double powerOfTwoAbove(double size) {
        return Math.scalb(1.0, Math.getExponent(size) + 1);
    }

    private static double size(Scene scene) {
        DoubleStream ofSurfaces = scene.surfaces().stream().mapToDouble(MovedSceneTest::largestCoordinate);
        return Math.max(largestPart(scene.camera().position()), ofSurfaces.max().orElse(0));
    }

    /** Of a plane, its distance from the world's origin. */
    private static double largestCoordinate(Surface surface) {
        if (surface instanceof Sphere sphere) {
            return largestPart(sphere.centre()) + sphere.radius();
        }
        if (surface instanceof Plane plane) {
            return Math.abs(plane.offset()) / plane.normal().length();
        }
        if (surface instanceof Triangle triangle) {
            return triangle.largestPart();
        }
        Box box = (Box) surface;
        return largestPart(box.centre()) + box.edge() / 2;
    }

    private static double largestPart(Vector vector) {
        return Math.max(Math.abs(vector.x()), Math.max(Math.abs(vector.y()), Math.abs(vector.z())));
    }

    private static Scene withHardShadowsAndShortNormals(Scene scene) {
        Settings settings = scene.settings();
        Settings hard = new Settings(settings.background(), 1, settings.maxReflections(), settings.ambientScale());
        List<Surface> surfaces = scene.surfaces().stream().map(MovedSceneTest::withShortNormal).toList();
        return new Scene(scene.camera(), hard, scene.materials(), surfaces, scene.lights());
    }

    private static Surface withShortNormal(Surface surface) {
        if (surface instanceof Plane plane) {
            Vector normal = plane.normal();
            Vector rounded = new Vector((float) normal.x(), (float) normal.y(), (float) normal.z());
            return new Plane(rounded, plane.offset(), plane.material());
        }
        return surface;
    }
}
