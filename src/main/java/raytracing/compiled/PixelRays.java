package raytracing.compiled;

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
        // Only the shape of the screen matters: its larger length comes near 1, and the other may round to 0 beside it.
        int exponent = -Math.getExponent(Math.max(camera.screenDistance(), camera.screenWidth()));
        screenDistance = Math.scalb(camera.screenDistance(), exponent);
        screenWidth = Math.scalb(camera.screenWidth(), exponent);
        screenHeight = screenWidth * height / width;
    }

    /**
     * Starts a walk along the ray through a place of the picture, of unit direction.
     *
     * @param x picture coordinate
     * @param y picture coordinate
     * @param walk takes the ray
     * @return false where the lens shows black: no light arrives there, or only from behind the camera
     */
    public boolean start(double x, double y, RayWalk walk) {
        double right = (x / width - 0.5) * screenWidth;
        double up = (0.5 - y / height) * screenHeight;
        if (right == 0 && up == 0) {         // the distance may be 0 beside the width
            startTowards(1, 0, 0, walk);
            return true;
        }
        if (camera.lens() instanceof Fisheye fisheye && fisheye.k() != 1) {
            return startThroughFisheye(fisheye, right, up, walk);
        }
        startTowards(screenDistance, right, up, walk);
        return true;
    }

    /** Sine and cosine of the angle, never its tangent: nothing grows without bound near a right angle. */
    private boolean startThroughFisheye(Fisheye fisheye, double right, double up, RayWalk walk) {
        double radius = Vector.length(right, up, 0);
        double angle = fisheye.incidentAngle(radius / screenDistance);
        if (!(angle < Math.PI / 2)) {        // this way round, NaN is black
            return false;
        }
        double sideways = StrictMath.sin(angle) / radius;
        startTowards(StrictMath.cos(angle), sideways * right, sideways * up, walk);
        return true;
    }

    private void startTowards(double forward, double right, double up, RayWalk walk) {
        double x = forward * forwardAxis.x() + right * rightAxis.x() + up * upAxis.x();
        double y = forward * forwardAxis.y() + right * rightAxis.y() + up * upAxis.y();
        double z = forward * forwardAxis.z() + right * rightAxis.z() + up * upAxis.z();
        double scale = Vector.safeScale(x, y, z);
        double factor = Vector.unitFactor(scale * x, scale * y, scale * z);
        walk.start(camera.position(), scale * x * factor, scale * y * factor, scale * z * factor);
    }
}
