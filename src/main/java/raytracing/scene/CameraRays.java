package raytracing.scene;

import raytracing.math.Vector;
import raytracing.surface.Ray;

/**
 * The rays that a camera sends through a picture of a given size. Picture coordinates count in pixels: x to the
 * right and y down from the upper left corner, so pixel (i, j) has its centre at (i + 1/2, j + 1/2). Immutable.
 */
public final class CameraRays {
    private final Camera camera;
    private final Vector rightAxis;
    private final Vector upAxis;
    private final Vector forwardAxis;
    private final int width;
    private final int height;
    private final double screenDistance;
    private final double screenWidth;
    private final double screenHeight;

    /** Prepares a camera, whose screen is as wide as the picture, for a picture size in pixels. */
    public CameraRays(Camera camera, int width, int height) {
        this.camera = camera;
        this.width = width;
        this.height = height;
        rightAxis = camera.right();
        forwardAxis = camera.forward();
        upAxis = forwardAxis.cross(rightAxis);
        // Only the shape of the screen matters: its larger length comes near 1, and the other may round to 0 beside it.
        int exponent = -Math.getExponent(Math.max(camera.screenDistance(), camera.screenWidth()));
        screenDistance = Math.scalb(camera.screenDistance(), exponent);
        screenWidth = Math.scalb(camera.screenWidth(), exponent);
        screenHeight = screenWidth * height / width;
    }

    /**
     * Starts the ray through a point of the picture, with a direction of length 1.
     *
     * @return false where the lens shows black: no light arrives there, or only from behind the camera
     */
    public boolean start(double x, double y, Ray ray) {
        double right = right(x);
        double up = up(y);
        double forward = screenDistance;
        if (right == 0 && up == 0) {         // the distance may be 0
            forward = 1;
            right = 0;                       // and not -0
            up = 0;
        } else if (camera.lens() instanceof Fisheye fisheye && fisheye.k() != 1) {
            double radius = Vector.length(right, up, 0);
            double angle = fisheye.incidentAngle(radius / screenDistance);
            if (!(angle < Math.PI / 2)) {    // this way round, NaN is black
                return false;
            }
            // sine and cosine of the angle, never its tangent: nothing grows without bound near a right angle
            double sideways = StrictMath.sin(angle) / radius;
            forward = StrictMath.cos(angle);
            right *= sideways;
            up *= sideways;
        }
        ray.startAt(camera.position(),
            forward * forwardAxis.x() + right * rightAxis.x() + up * upAxis.x(),
            forward * forwardAxis.y() + right * rightAxis.y() + up * upAxis.y(),
            forward * forwardAxis.z() + right * rightAxis.z() + up * upAxis.z());
        return true;
    }

    private double right(double x) {
        return (x / width - 0.5) * screenWidth;
    }

    private double up(double y) {
        return (0.5 - y / height) * screenHeight;
    }

    /**
     * How far a point of the picture is from its middle, in screen distances, as {@link #start} computes it. It never falls
     * while x or y goes away from the middle: all three roundings keep the order of numbers.
     */
    public double radius(double x, double y) {
        return Vector.length(right(x), up(y), 0) / screenDistance;
    }

    /** The edges of how many pixels are as long as the screen distance. */
    public double pixelsPerScreenDistance() {
        return width * (screenDistance / screenWidth);
    }

    public Camera camera() {
        return camera;
    }

    /** Width of the picture in pixels. */
    public int width() {
        return width;
    }

    /** Height of the picture in pixels. */
    public int height() {
        return height;
    }
}
