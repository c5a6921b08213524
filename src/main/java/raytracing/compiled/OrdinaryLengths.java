package raytracing.compiled;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import raytracing.geometry.Box;
import raytracing.geometry.Plane;
import raytracing.geometry.Sphere;
import raytracing.geometry.Surface;
import raytracing.math.Vector;
import raytracing.scene.Camera;
import raytracing.scene.Light;
import raytracing.scene.Scene;

/**
 * Brings scenes of huge or tiny lengths to ordinary ones, where the quick questions about surfaces have an answer: squares
 * stay in the range of doubles. Only ratios of lengths are seen, so a power of two changes no bit of the picture; a scene
 * that would lose a digit, as it mixes huge and tiny, stays as it is. The point at which the camera looks is no length:
 * only its direction counts.
 */
public final class OrdinaryLengths {
    /** Products of six lengths between 2^-100 and 2^100 are normal numbers. */
    private static final int ORDINARY = 100;

    private final int exponent;
    private boolean isExact = true;

    private OrdinaryLengths(int exponent) {
        this.exponent = exponent;
    }

    /**
     * The scene with most of its lengths near 1.
     *
     * @param scene any scene
     * @return a scene of the same picture; the same one if its lengths are ordinary, or cannot be exactly
     */
    public static Scene of(Scene scene) {
        int exponent = middleExponent(scene);
        if (Math.abs(exponent) <= ORDINARY && arePlanesOrdinary(scene)) {
            return scene;
        }
        OrdinaryLengths lengths = new OrdinaryLengths(Math.abs(exponent) <= ORDINARY ? 0 : exponent);
        Scene scaled = lengths.scaled(scene);
        return lengths.isExact ? scaled : scene;
    }

    /** A loop, for this is on every picture's way, and a cold machine takes long for its first lambda. */
    private static boolean arePlanesOrdinary(Scene scene) {
        for (Surface surface : scene.surfaces()) {
            if (!isOrdinaryPlane(surface)) {
                return false;
            }
        }
        return true;
    }

    private static boolean isOrdinaryPlane(Surface surface) {
        return !(surface instanceof Plane plane) || Math.abs(normalExponent(plane)) <= ORDINARY;
    }

    private static int normalExponent(Plane plane) {
        return exponent(plane.normal().largestPart());
    }

    /** That of the length in the middle: as many are larger as are smaller; 0 if all are ordinary. */
    private static int middleExponent(Scene scene) {
        int[] exponents = new int[1 + 2 * scene.lights().size() + 2 * scene.surfaces().size()];
        int count = add(scene.camera().position().largestPart(), exponents, 0);
        for (Light light : scene.lights()) {
            count = add(light.position().largestPart(), exponents, count);
            count = add(light.width(), exponents, count);
        }
        for (Surface surface : scene.surfaces()) {
            if (surface instanceof Sphere sphere) {
                count = add(sphere.centre().largestPart(), exponents, count);
                count = add(sphere.radius(), exponents, count);
            } else if (surface instanceof Box box) {
                count = add(box.centre().largestPart(), exponents, count);
                count = add(box.edge(), exponents, count);
            } else if (surface instanceof Plane plane && plane.offset() != 0) {
                exponents[count++] = exponent(plane.offset()) - normalExponent(plane);
            }
        }
        return areOrdinary(exponents, count) ? 0 : middle(exponents, count);
    }

    private static boolean areOrdinary(int[] exponents, int count) {
        int furthest = 0;
        for (int i = 0; i < count; i++) {
            furthest = Math.max(furthest, Math.abs(exponents[i]));
        }
        return furthest <= ORDINARY;
    }

    private static int middle(int[] exponents, int count) {
        Arrays.sort(exponents, 0, count);
        return exponents[count / 2];
    }

    private static int add(double length, int[] exponents, int count) {
        if (length == 0) {
            return count;
        }
        exponents[count] = exponent(length);
        return count + 1;
    }

    /** Also of a number below all normal ones. */
    private static int exponent(double value) {
        return Math.abs(value) >= Double.MIN_NORMAL ? Math.getExponent(value)
            : Math.getExponent(Math.scalb(value, -Double.MIN_EXPONENT)) + Double.MIN_EXPONENT;
    }

    private Scene scaled(Scene scene) {
        Camera camera = scene.camera();
        List<Surface> surfaces = new ArrayList<>();
        for (Surface surface : scene.surfaces()) {
            surfaces.add(scaled(surface));
        }
        List<Light> lights = new ArrayList<>();
        for (Light light : scene.lights()) {
            lights.add(new Light(scaled(light.position(), exponent), light.color(), light.specularIntensity(),
                light.shadowIntensity(), scaled(light.width(), exponent)));
        }
        return new Scene(new Camera(scaled(camera.position(), exponent), scaled(camera.lookAt(), exponent), camera.up(),
            camera.screenDistance(), camera.screenWidth(), camera.lens()), scene.settings(), scene.materials(),
            surfaces, lights);
    }

    private Surface scaled(Surface surface) {
        if (surface instanceof Sphere sphere) {
            return new Sphere(scaled(sphere.centre(), exponent), scaled(sphere.radius(), exponent), sphere.material());
        }
        if (surface instanceof Box box) {
            return new Box(scaled(box.centre(), exponent), scaled(box.edge(), exponent), box.material());
        }
        Plane plane = (Plane) surface;
        int slope = isOrdinaryPlane(plane) ? 0 : normalExponent(plane);
        return new Plane(scaled(plane.normal(), slope), scaled(plane.offset(), slope + exponent), plane.material());
    }

    private Vector scaled(Vector vector, int down) {
        return new Vector(scaled(vector.x(), down), scaled(vector.y(), down), scaled(vector.z(), down));
    }

    private double scaled(double value, int down) {
        double scaled = Math.scalb(value, -down);
        isExact &= Math.scalb(scaled, down) == value;
        return scaled;
    }
}
