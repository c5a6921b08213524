package raytracing.trace;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import raytracing.math.Vector;
import raytracing.scene.Camera;
import raytracing.scene.Light;
import raytracing.scene.Scene;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

/**
 * Brings scenes of huge or tiny lengths to ordinary ones, where doubles decide queries: squares stay in their range. Only
 * ratios of lengths are seen, so a power of two changes no bit of the picture; a scene that would lose a digit, as it mixes
 * huge and tiny, stays as it is. The point at which the camera looks is no length: only its direction counts.
 */
public final class OrdinaryLengths {
    /** Products of six lengths between 2^-100 and 2^100 are normal numbers. */
    private static final int ORDINARY = 100;

    private OrdinaryLengths() {
    }

    /** A scene of the same picture with most of its lengths near 1; the same one if that is so, or cannot be exactly. */
    public static Scene of(Scene scene) {
        if (isOrdinary(scene)) {
            return scene;
        }
        Exponents exponents = new Exponents(scene);
        int middle = exponents.middle();
        if (Math.abs(middle) <= ORDINARY && exponents.areNormalsOrdinary) {
            return scene;
        }
        Scaling scaling = new Scaling(Math.abs(middle) <= ORDINARY ? 0 : middle);
        Scene scaled = scaling.scaled(scene);
        return scaling.isExact ? scaled : scene;
    }

    /** A first look, which is all that nearly all scenes need: a million surfaces would take long to be collected. */
    private static boolean isOrdinary(Scene scene) {
        boolean isOrdinary = isOrdinary(scene.camera().position().largestPart());
        for (Light light : scene.lights()) {
            isOrdinary &= isOrdinary(light.position().largestPart()) && isOrdinary(light.width());
        }
        Ordinary ordinary = new Ordinary();
        for (Surface surface : scene.surfaces()) {
            isOrdinary &= surface.accept(ordinary);
        }
        return isOrdinary;
    }

    private static boolean isOrdinary(double length) {
        return length == 0 || Math.abs(Math.getExponent(length)) <= ORDINARY;
    }

    private static int exponent(Vector vector) {
        return exponent(vector.largestPart());
    }

    /** Also of a subnormal number. */
    private static int exponent(double value) {
        return Math.abs(value) >= Double.MIN_NORMAL ? Math.getExponent(value)
            : Math.getExponent(Math.scalb(value, -Double.MIN_EXPONENT)) + Double.MIN_EXPONENT;
    }

    private static boolean isOrdinary(int exponent) {
        return Math.abs(exponent) <= ORDINARY;
    }

    /** Whether all lengths of a surface are ordinary, and the normal of a plane. */
    private static final class Ordinary implements Surface.Visitor<Boolean> {
        @Override
        public Boolean visit(Sphere sphere) {
            return isOrdinary(sphere.centre().largestPart()) && isOrdinary(sphere.radius());
        }

        @Override
        public Boolean visit(Plane plane) {
            return isOrdinary(plane.normal().largestPart()) && isOrdinary(plane.offset())
                && isOrdinary(exponent(plane.offset()) - exponent(plane.normal()));
        }

        @Override
        public Boolean visit(Box box) {
            return isOrdinary(box.centre().largestPart()) && isOrdinary(box.edge());
        }

        @Override
        public Boolean visit(Triangle triangle) {
            return isOrdinary(triangle.largestPart()) && isOrdinary(triangle.extent());
        }
    }

    /** The exponents of a scene's lengths but 0. */
    private static final class Exponents implements Surface.Visitor<Boolean> {
        private int[] exponents = new int[16];
        private int count;
        private boolean areOrdinary = true;
        private boolean areNormalsOrdinary = true;

        Exponents(Scene scene) {
            add(scene.camera().position().largestPart());
            for (Light light : scene.lights()) {
                add(light.position().largestPart());
                add(light.width());
            }
            for (Surface surface : scene.surfaces()) {
                surface.accept(this);
            }
        }

        private boolean add(double length) {
            return length == 0 || add(exponent(length));
        }

        private boolean add(int exponent) {
            if (count == exponents.length) {
                exponents = Arrays.copyOf(exponents, 2 * count);
            }
            exponents[count++] = exponent;
            areOrdinary &= isOrdinary(exponent);
            return true;
        }

        @Override
        public Boolean visit(Sphere sphere) {
            return add(sphere.centre().largestPart()) && add(sphere.radius());
        }

        @Override
        public Boolean visit(Plane plane) {
            areNormalsOrdinary &= isOrdinary(exponent(plane.normal()));
            return plane.offset() == 0 || add(exponent(plane.offset()) - exponent(plane.normal()));
        }

        @Override
        public Boolean visit(Box box) {
            return add(box.centre().largestPart()) && add(box.edge());
        }

        @Override
        public Boolean visit(Triangle triangle) {
            return add(triangle.largestPart()) && add(triangle.extent());
        }

        /** That of the length in the middle: as many are larger as are smaller; 0 if all are ordinary. */
        int middle() {
            if (areOrdinary) {
                return 0;
            }
            Arrays.sort(exponents, 0, count);
            return exponents[count / 2];
        }
    }

    /** Divides lengths by a power of two, and extraordinary normals of planes by one of their own. */
    private static final class Scaling implements Surface.Visitor<Surface> {
        private final int exponent;
        private boolean isExact = true;

        Scaling(int exponent) {
            this.exponent = exponent;
        }

        Scene scaled(Scene scene) {
            Camera camera = scene.camera();
            List<Surface> surfaces = new ArrayList<>();
            for (Surface surface : scene.surfaces()) {
                surfaces.add(surface.accept(this));
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

        @Override
        public Surface visit(Sphere sphere) {
            return new Sphere(scaled(sphere.centre(), exponent), scaled(sphere.radius(), exponent), sphere.material());
        }

        @Override
        public Surface visit(Plane plane) {
            int normal = exponent(plane.normal());
            int slope = isOrdinary(normal) ? 0 : normal;
            return new Plane(scaled(plane.normal(), slope), scaled(plane.offset(), slope + exponent), plane.material());
        }

        @Override
        public Surface visit(Box box) {
            return new Box(scaled(box.centre(), exponent), scaled(box.edge(), exponent), box.material());
        }

        @Override
        public Surface visit(Triangle triangle) {
            return Triangle.of(scaled(triangle.a(), exponent), scaled(triangle.b(), exponent), scaled(triangle.c(), exponent),
                triangle.material());
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
}
