package raytracing.timed;

import raytracing.color.Color;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.scene.Camera;
import raytracing.scene.Light;
import raytracing.scene.Material;
import raytracing.scene.Scene;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

/**
 * A scene in POV-Ray's scene description language: as much work, and nearly the same picture. What POV-Ray cannot
 * express is left out: the share of its light that an obstacle stops, each light's own highlights, the fisheye. Its lights
 * are round where ours are square.
 */
public final class ToPovRay {
    /** POV-Ray refuses more. */
    private static final int DEEPEST = 256;

    /** The number of no material. */
    private static final int NO_MESH = -1;

    private final StringBuilder text = new StringBuilder();
    private final int shadowRayRoot;
    private final String method;

    /** The material of the mesh that the last line is in. */
    private int mesh = NO_MESH;

    private ToPovRay(int shadowRayRoot, String method) {
        this.shadowRayRoot = shadowRayRoot;
        this.method = method;
    }

    /** A whole file for POV-Ray 3.7, for a square picture. */
    public static String of(Scene scene) {
        return of(scene, scene.settings().shadowRayRoot(), "jitter");
    }

    /**
     * With other soft shadows than the scene asks for.
     *
     * @param shadowRayRoot N of N x N points on each wide light
     * @param method what else POV-Ray is told about them, such as {@code jitter adaptive 1}
     */
    public static String of(Scene scene, int shadowRayRoot, String method) {
        ToPovRay translation = new ToPovRay(shadowRayRoot, method);
        // POV-Ray counts the ray from the eye as the first level.
        int levels = Math.min(DEEPEST, scene.settings().maxReflections() + 1);
        translation.line("#version 3.7;");
        translation.line("global_settings { assumed_gamma 1 max_trace_level " + levels + " }");
        translation.line("background { rgb " + triple(scene.settings().background()) + " }");
        translation.camera(scene.camera());
        scene.lights().forEach(translation::light);
        for (int i = 0; i < scene.materials().size(); i++) {
            translation.material(i, scene.materials().get(i));
        }
        Writer writer = translation.new Writer();
        scene.surfaces().forEach(surface -> surface.accept(writer));
        translation.end();
        return translation.text.toString();
    }

    /** POV-Ray's axes are left-handed too; {@code look_at} turns the other vectors and keeps their lengths. */
    private void camera(Camera camera) {
        double width = camera.screenWidth();
        line("camera { perspective location " + triple(camera.position()) + " sky " + triple(camera.up())
            + " up " + triple(new Vector(0, width, 0)) + " right " + triple(new Vector(width, 0, 0))
            + " direction " + triple(new Vector(0, 0, camera.screenDistance()))
            + " look_at " + triple(camera.lookAt()) + " }");
    }

    private void light(Light light) {
        line("light_source { " + triple(light.position()) + " rgb " + triple(light.color()) + shadows(light) + " }");
    }

    private String shadows(Light light) {
        if (light.shadowIntensity() == 0) {
            return " shadowless";
        }
        if (light.width() == 0 || shadowRayRoot == 1) {
            return "";
        }
        return " area_light " + triple(new Vector(light.width(), 0, 0)) + ", " + triple(new Vector(0, light.width(), 0))
            + ", " + shadowRayRoot + ", " + shadowRayRoot + " " + method + " circular orient";
    }

    private void material(int number, Material material) {
        line("#declare " + name(number) + " = texture { pigment { rgb " + triple(material.diffuse())
            + " transmit " + material.transparency() + " } finish { ambient 0 diffuse 1 phong "
            + mean(material.specular()) + " phong_size " + material.phongExponent()
            + " reflection { rgb " + triple(material.reflection()) + " } } }");
    }

    private final class Writer implements Surface.Visitor<Boolean> {
        @Override
        public Boolean visit(Sphere sphere) {
            end().line("sphere { " + triple(sphere.centre()) + ", " + sphere.radius() + texture(sphere));
            return true;
        }

        /** POV-Ray's offset is a length: it makes the normal a unit vector. */
        @Override
        public Boolean visit(Plane plane) {
            double offset = plane.offset() / plane.normal().length();
            end().line("plane { " + triple(plane.normal()) + ", " + offset + texture(plane));
            return true;
        }

        @Override
        public Boolean visit(Box box) {
            Vector half = new Vector(box.edge(), box.edge(), box.edge()).times(0.5);
            end().line("box { " + triple(box.centre().minus(half)) + ", " + triple(Vectors.plus(box.centre(), half))
                + texture(box));
            return true;
        }

        /** Those of one material in a row are a mesh, which POV-Ray draws faster than single ones. */
        @Override
        public Boolean visit(Triangle triangle) {
            if (triangle.material() != mesh) {
                end().line("mesh {");
                mesh = triangle.material();
            }
            line("triangle { " + triple(triangle.a()) + ", " + triple(triangle.b()) + ", " + triple(triangle.c()) + " }");
            return true;
        }
    }

    /** Ends the mesh, if there is one. */
    private ToPovRay end() {
        if (mesh != NO_MESH) {
            line("texture { " + name(mesh) + " } }");
            mesh = NO_MESH;
        }
        return this;
    }

    private void line(String line) {
        text.append(line).append('\n');
    }

    private static String texture(Surface surface) {
        return " texture { " + name(surface.material()) + " } }";
    }

    private static String name(int material) {
        return "M" + material;
    }

    /** POV-Ray's highlights have the colour of the light. */
    private static double mean(Color color) {
        return (color.red() + color.green() + color.blue()) / 3;
    }

    private static String triple(Color color) {
        return triple(new Vector(color.red(), color.green(), color.blue()));
    }

    private static String triple(Vector vector) {
        return "<" + vector.x() + ", " + vector.y() + ", " + vector.z() + ">";
    }
}
