package raytracing.timed;

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

/** The text of a scene, from which the parser makes the same scene again, to the last bit. */
public final class SceneLines {
    private final StringBuilder text = new StringBuilder();

    private SceneLines() {
    }

    /** A whole scene file. */
    public static String of(Scene scene) {
        SceneLines lines = new SceneLines();
        lines.camera(scene.camera());
        lines.settings(scene.settings());
        scene.materials().forEach(lines::material);
        Writer writer = lines.new Writer();
        scene.surfaces().forEach(surface -> surface.accept(writer));
        scene.lights().forEach(lines::light);
        return lines.text.toString();
    }

    private void camera(Camera camera) {
        line("cam").with(camera.position()).with(camera.lookAt()).with(camera.up())
            .with(camera.screenDistance()).with(camera.screenWidth());
        if (camera.lens() instanceof Fisheye fisheye) {
            text.append(" true");
            with(fisheye.k());
        }
    }

    private void settings(Settings settings) {
        line("set").with(settings.background()).with(settings.shadowRayRoot()).with(settings.maxReflections())
            .with(settings.ambientScale());
    }

    private void material(Material material) {
        line("mtl").with(material.diffuse()).with(material.specular()).with(material.reflection())
            .with(material.phongExponent()).with(material.transparency()).with(material.ambient());
    }

    private void light(Light light) {
        line("lgt").with(light.position()).with(light.color()).with(light.specularIntensity())
            .with(light.shadowIntensity()).with(light.width());
    }

    private final class Writer implements Surface.Visitor<Boolean> {
        @Override
        public Boolean visit(Sphere sphere) {
            line("sph").with(sphere.centre()).with(sphere.radius()).withMaterial(sphere);
            return true;
        }

        @Override
        public Boolean visit(Plane plane) {
            line("pln").with(plane.normal()).with(plane.offset()).withMaterial(plane);
            return true;
        }

        @Override
        public Boolean visit(Box box) {
            line("box").with(box.centre()).with(box.edge()).withMaterial(box);
            return true;
        }

        @Override
        public Boolean visit(Triangle triangle) {
            line("trg").with(triangle.a()).with(triangle.b()).with(triangle.c()).withMaterial(triangle);
            return true;
        }
    }

    /** Begins a line with its code; text that ends without a line's end is a scene file too. */
    private SceneLines line(String code) {
        text.append(text.isEmpty() ? "" : "\n").append(code);
        return this;
    }

    private SceneLines with(double number) {
        text.append(' ').append(number);
        return this;
    }

    private SceneLines with(Vector vector) {
        return with(vector.x()).with(vector.y()).with(vector.z());
    }

    private SceneLines with(Color color) {
        return with(color.red()).with(color.green()).with(color.blue());
    }

    /** Files count materials from 1. */
    private void withMaterial(Surface surface) {
        text.append(' ').append(surface.material() + 1);
    }
}
