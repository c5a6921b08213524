package raytracing.fuzz;

import raytracing.color.Color;
import raytracing.math.Vector;
import raytracing.scene.Camera;
import raytracing.scene.Fisheye;
import raytracing.scene.Light;
import raytracing.scene.Material;
import raytracing.scene.Scene;
import raytracing.scene.Settings;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

/** The ranges that the format gives to a scene's numbers. */
final class SceneRanges {
    private static final double LARGEST = Double.MAX_VALUE;
    private static final double LEAST_ABOVE_0 = Double.MIN_VALUE;

    private SceneRanges() {
    }

    /** Throws an {@link AssertionError} that names the first number out of range. */
    static void check(Scene scene) {
        check(scene.camera());
        check(scene.settings());
        scene.materials().forEach(SceneRanges::check);
        scene.lights().forEach(SceneRanges::check);
        for (Surface surface : scene.surfaces()) {
            check(surface, scene.materials().size());
        }
    }

    private static void check(Camera camera) {
        finite("position", camera.position());
        finite("look-at", camera.lookAt());
        direction("up", camera.up());
        within("screen distance", camera.screenDistance(), LEAST_ABOVE_0, LARGEST);
        within("screen width", camera.screenWidth(), LEAST_ABOVE_0, LARGEST);
        if (camera.lens() instanceof Fisheye fisheye) {
            within("k", fisheye.k(), -1, 1);
        }
        direction("right", camera.right());
    }

    private static void check(Settings settings) {
        color("background", settings.background());
        within("shadow ray root", settings.shadowRayRoot(), 1, 1024);
        within("maximum recursion", settings.maxReflections(), 0, 1000);
        within("ambient scale", settings.ambientScale(), 0, LARGEST);
    }

    private static void check(Material material) {
        color("diffuse", material.diffuse());
        color("specular", material.specular());
        color("reflection", material.reflection());
        within("exponent", material.phongExponent(), 0, LARGEST);
        within("transparency", material.transparency(), 0, 1);
        color("ambient", material.ambient());
    }

    private static void check(Surface surface, int materials) {
        within("material", surface.material(), 0, materials - 1);
        if (surface instanceof Sphere sphere) {
            finite("centre", sphere.centre());
            within("radius", sphere.radius(), LEAST_ABOVE_0, LARGEST);
        } else if (surface instanceof Box box) {
            finite("centre", box.centre());
            within("edge", box.edge(), LEAST_ABOVE_0, LARGEST);
        } else if (surface instanceof Plane plane) {
            direction("normal", plane.normal());
            within("offset", plane.offset(), -LARGEST, LARGEST);
        } else if (surface instanceof Triangle triangle) {
            finite("first corner", triangle.a());
            finite("second corner", triangle.b());
            finite("third corner", triangle.c());
        }
    }

    private static void check(Light light) {
        finite("position", light.position());
        color("colour", light.color());
        within("specular intensity", light.specularIntensity(), 0, LARGEST);
        within("shadow intensity", light.shadowIntensity(), 0, 1);
        within("width", light.width(), 0, LARGEST);
    }

    private static void direction(String name, Vector vector) {
        finite(name, vector);
        AnyBytes.claim(!vector.isZero(), name + " is no direction", vector);
    }

    private static void finite(String name, Vector vector) {
        within(name, vector.x(), -LARGEST, LARGEST);
        within(name, vector.y(), -LARGEST, LARGEST);
        within(name, vector.z(), -LARGEST, LARGEST);
    }

    private static void color(String name, Color color) {
        within(name, color.red(), 0, LARGEST);
        within(name, color.green(), 0, LARGEST);
        within(name, color.blue(), 0, LARGEST);
    }

    private static void within(String name, double value, double least, double most) {
        AnyBytes.claim(value >= least && value <= most, name + " out of range", value);
    }
}
