package raytracing;

import java.util.List;
import java.util.function.UnaryOperator;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.scene.Camera;
import raytracing.scene.Light;
import raytracing.scene.Scene;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

/**
 * Takes a scene, camera and all, to another place in the world; its picture stays the same.
 *
 * @param turn a turn about the world's origin that takes axes to axes, as boxes stay along them
 * @param shift added after the turn
 */
record Motion(UnaryOperator<Vector> turn, Vector shift) {
    static Motion by(Vector shift) {
        return new Motion(UnaryOperator.identity(), shift);
    }

    static Motion about(UnaryOperator<Vector> turn) {
        return new Motion(turn, Vector.ZERO);
    }

    Scene moved(Scene scene) {
        Camera camera = scene.camera();
        Camera movedCamera = new Camera(moved(camera.position()), moved(camera.lookAt()), turn.apply(camera.up()),
            camera.screenDistance(), camera.screenWidth(), camera.lens());
        List<Surface> surfaces = scene.surfaces().stream().map(this::moved).toList();
        List<Light> lights = scene.lights().stream().map(light -> new Light(moved(light.position()), light.color(),
            light.specularIntensity(), light.shadowIntensity(), light.width())).toList();
        return new Scene(movedCamera, scene.settings(), scene.materials(), surfaces, lights);
    }

    private Vector moved(Vector point) {
        return Vectors.plus(turn.apply(point), shift);
    }

    private Surface moved(Surface surface) {
        if (surface instanceof Sphere sphere) {
            return new Sphere(moved(sphere.centre()), sphere.radius(), sphere.material());
        }
        if (surface instanceof Plane plane) {
            Vector normal = turn.apply(plane.normal());
            return new Plane(normal, plane.offset() + normal.dot(shift), plane.material());
        }
        if (surface instanceof Triangle triangle) {
            return Triangle.of(moved(triangle.a()), moved(triangle.b()), moved(triangle.c()), triangle.material());
        }
        Box box = (Box) surface;
        return new Box(moved(box.centre()), box.edge(), box.material());
    }
}
