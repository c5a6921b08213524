package raytracing.outline;

import raytracing.math.Vector;
import raytracing.scene.Camera;
import raytracing.scene.CameraRays;
import raytracing.scene.Fisheye;

/**
 * How large a body is in the picture: bounds for the disc of pixels that it certainly fills and for the area that it can
 * fill at most, and from these how many rays notice it.
 *
 * <p>Pinhole: a ball whose directions are within beta of one that is phi off the view fills an ellipse on the screen with
 * the half axes f sin(beta) / w and f sin(beta) cos(beta) / w^2, with f the screen distance and w^2 = cos(phi)^2 -
 * sin(beta)^2. Fisheye: it fills at least a disc of radius f beta / L, with L the greatest rate at which directions turn on
 * the screen, as in {@link SquareCone}; and at most its solid angle, below pi beta^2, times f^2 over the least product of
 * both rates. Not thread-safe.
 */
final class SmallBodies {
    /** The fewest and the most rays in a pixel that holds an outline. */
    static final int FEWEST = 16;
    static final int MOST = 4096;

    /** More than a hundred times the error of any quotient here. */
    private static final double CERTAIN = 1 - 0x1p-40;

    /** How far an angle from acos or asin may be off: the square root of a few u. */
    private static final double ANGLE = 0x1p-22;

    /** The half axes of the ellipse are known if its ball is clearly before the camera. */
    private static final double CLEAR = 4;

    private final Vector forward;
    private final double scale;
    private final double k;

    private double radius;
    private double area;

    SmallBodies(CameraRays rays) {
        Camera camera = rays.camera();
        forward = camera.forward();
        scale = rays.pixelsPerScreenDistance();
        k = camera.lens() instanceof Fisheye fisheye ? fisheye.k() : 1;
    }

    /** Looks at a surface that is not small. */
    void lookAtEndless() {
        radius = Double.POSITIVE_INFINITY;
        area = Double.POSITIVE_INFINITY;
    }

    /**
     * Looks at a body between two balls.
     *
     * @param x way from the eye to the middle of both
     * @param inner radius of a ball inside the body
     * @param outer radius of a ball around it
     */
    void look(double x, double y, double z, double inner, double outer) {
        double distance = Vector.length(x, y, z);
        lookAtEndless();
        if (outer < distance) {
            double ahead = (x * forward.x() + y * forward.y() + z * forward.z()) / distance;
            if (k == 1) {
                lookThroughPinhole(ahead, inner / distance, outer / distance);
            } else {
                lookThroughFisheye(ahead, inner / distance, outer / distance);
            }
        }
    }

    private void lookThroughPinhole(double ahead, double innerSine, double outerSine) {
        double square = ahead * ahead - outerSine * outerSine;
        if (ahead > CLEAR * outerSine) {
            radius = CERTAIN * scale * innerSine / ahead;
            area = Math.PI * scale * scale * outerSine * outerSine / (CERTAIN * square * Math.sqrt(square));
        }
    }

    private void lookThroughFisheye(double ahead, double innerSine, double outerSine) {
        double middle = StrictMath.acos(Math.max(-1, Math.min(1, ahead)));
        double spread = StrictMath.asin(outerSine) + ANGLE;
        double low = Math.max(0, middle - spread);
        double high = Math.min(Math.PI / 2, middle + spread);
        double around = k < 0 ? 1 : around(low);
        radius = CERTAIN * scale * innerSine / Math.max(outwards(k < 0 ? high : low), around);
        double least = outwards(k < 0 ? low : high) * around(high);
        area = Math.PI * scale * scale * spread * spread / (CERTAIN * least);
    }

    /** The rate d theta / dR in a picture whose screen distance is 1. */
    private double outwards(double theta) {
        double cosine = StrictMath.cos(k * theta);
        return k < 0 ? 1 / cosine : cosine * cosine;
    }

    /** The rate sin(theta) / R there. */
    private double around(double theta) {
        double onScreen = k == 0 ? theta : (k < 0 ? StrictMath.sin(k * theta) : StrictMath.tan(k * theta)) / k;
        return theta < ANGLE ? 1 : StrictMath.sin(theta) / onScreen;
    }

    /** The largest area that the body can fill, in pixels; infinite if it is not small. */
    double area() {
        return area;
    }

    /**
     * The fewest points of a (0, 2)-net in each pixel, a power of four, that certainly hit the body. There is a point in
     * each cell of side s = 2^-k if there are 4^k points, and a disc of radius s sqrt(2) holds the cell of its middle.
     */
    int rays() {
        int rays = FEWEST;
        while (rays < MOST && !(radius * radius * rays >= 2)) {
            rays *= 4;
        }
        return rays;
    }
}
