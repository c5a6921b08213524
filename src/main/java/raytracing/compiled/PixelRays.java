package raytracing.compiled;

import java.util.Optional;
import raytracing.geometry.Ray;
import raytracing.math.Basis;
import raytracing.math.Vector;
import raytracing.scene.Camera;
import raytracing.scene.Fisheye;

/**
 * The rays that a camera sends through a picture of a given size. Picture coordinates count in pixels: x to the
 * right and y down from the upper left corner, so pixel (i, j) has its centre at (i + 1/2, j + 1/2). Immutable.
 */
public final class PixelRays {
    private final Camera camera;
    private final Vector rightAxis;
    private final Vector upAxis;
    private final Vector forwardAxis;
    private final int width;
    private final int height;
    private final double screenDistance;
    private final double screenWidth;
    private final double screenHeight;

    /**
     * Prepares a camera for a picture size.
     *
     * @param camera the camera, whose screen is as wide as the picture
     * @param width of the picture in pixels, at least 1
     * @param height of the picture in pixels, at least 1
     */
    public PixelRays(Camera camera, int width, int height) {
        this.camera = camera;
        this.width = width;
        this.height = height;
        Basis basis = camera.basis();
        rightAxis = basis.u();
        upAxis = basis.v();
        forwardAxis = basis.w();
        // Only the shape of the screen matters. Near 1, no length of it leaves the range of doubles.
        int exponent = -Math.getExponent(Math.max(camera.screenDistance(), camera.screenWidth()));
        screenDistance = Math.scalb(camera.screenDistance(), exponent);
        screenWidth = Math.scalb(camera.screenWidth(), exponent);
        screenHeight = screenWidth * height / width;
    }

    /**
     * The ray through a place of the picture.
     *
     * @param x picture coordinate
     * @param y picture coordinate
     * @return a ray of unit direction, or none where the lens shows black: no light arrives there, or only from
     *         behind the camera
     */
    public Optional<Ray> through(double x, double y) {
        double right = (x / width - 0.5) * screenWidth;
        double up = (0.5 - y / height) * screenHeight;
        if (camera.lens() instanceof Fisheye fisheye && fisheye.k() != 1) {
            return throughFisheye(fisheye, right, up);
        }
        return Optional.of(towards(screenDistance, right, up));
    }

    /** Sine and cosine of the angle, never its tangent: nothing grows without bound near a right angle. */
    private Optional<Ray> throughFisheye(Fisheye fisheye, double right, double up) {
        double radius = new Vector(right, up, 0).length();
        if (radius == 0) {
            return Optional.of(towards(1, 0, 0));
        }
        double angle = fisheye.incidentAngle(radius / screenDistance);
        if (!(angle < Math.PI / 2)) {        // this way round, NaN is black
            return Optional.empty();
        }
        double sideways = StrictMath.sin(angle) / radius;
        return Optional.of(towards(StrictMath.cos(angle), sideways * right, sideways * up));
    }

    private Ray towards(double forward, double right, double up) {
        Vector direction = new Vector(
            forward * forwardAxis.x() + right * rightAxis.x() + up * upAxis.x(),
            forward * forwardAxis.y() + right * rightAxis.y() + up * upAxis.y(),
            forward * forwardAxis.z() + right * rightAxis.z() + up * upAxis.z());
        return new Ray(camera.position(), direction.unit());
    }
}
