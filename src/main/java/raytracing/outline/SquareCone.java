package raytracing.outline;

import java.util.Arrays;
import raytracing.math.Vector;
import raytracing.scene.CameraRays;
import raytracing.scene.Fisheye;
import raytracing.surface.Ray;

/**
 * A circular cone around all rays through a square of the picture: an axis, and the largest angle of a ray to it.
 *
 * <p>Pinhole: the rays through a square meet the screen in a square, and a cone of less than a right angle meets it in a
 * convex figure; so the cone that holds the rays through the four corners holds all. Fisheye: along any way on the screen
 * the direction turns at most L times as fast as the way is long in screen distances, with L the greater of d theta / dR
 * and sin(theta) / R, the rates away from the middle and around it. So a ray through a point at a distance s from another
 * is at most L s off the ray through that one. For k of at least 0 both rates fall with R, and sin(theta) is at most 1; for
 * k below 0 the first one is the greater and grows with R (derived from the formulas of {@link Fisheye}).
 *
 * <p>{@link #aim} alone writes the fields. Not thread-safe.
 */
final class SquareCone {
    /** What a square of the picture shows, as far as the lens decides it. */
    enum View {
        /** All rays are black. */
        BLACK,

        /** All rays go out from the eye, inside the cone. */
        LIT,

        /** Some rays may be black; the others are inside the cone. */
        BORDER,

        /** Nothing is known of the rays: their directions are too different for a cone. */
        TOO_WIDE
    }

    /**
     * 128 u, with u = 2^-53: directions are off by less than 16 u from those of the real numbers, and so are the sums and
     * products here.
     */
    private static final double ROUNDING = 0x1p-46;

    /** Cones are narrower than 60 degrees from axis to mantle. */
    private static final double SMALLEST_COSINE = 0.5;
    private static final double WIDEST = 0.86;

    /** Half an edge of a square, beside half its diagonal. */
    private static final double INSIDE = 0.7;

    /** The rounding of a place on the screen, beside the edge of a pixel, in pictures of at most 2^30 pixels in a row. */
    private static final double LENGTHENED = 1 + 0x1p-20;

    /** Nearer than this to where no light arrives from any angle, the rate d theta / dR is without useful bound. */
    private static final double LEAST_SQUARED_COSINE = 0x1p-20;

    /** Coordinates count in these parts of a pixel. */
    static final int PARTS = 4;

    private static final int CORNERS_IN_A_ROW = OutlineQuery.BLOCK * PARTS + 1;

    private final CameraRays rays;
    private final boolean isPinhole;
    private final double k;
    private final Ray ray = new Ray();

    /**
     * Directions through the corners of the parts of the block's pixels, three numbers each, and which of them are known.
     */
    private final double[] corners = new double[3 * CORNERS_IN_A_ROW * CORNERS_IN_A_ROW];
    private final boolean[] isKnown = new boolean[CORNERS_IN_A_ROW * CORNERS_IN_A_ROW];
    private int left;
    private int top;

    /** The eye, the unit axis, and sine and cosine of the largest angle to it. */
    final double eyeX;
    final double eyeY;
    final double eyeZ;
    double axisX;
    double axisY;
    double axisZ;
    double sine;
    double cosine;

    SquareCone(CameraRays rays) {
        this.rays = rays;
        Vector eye = rays.camera().position();
        eyeX = eye.x();
        eyeY = eye.y();
        eyeZ = eye.z();
        boolean isFisheye = rays.camera().lens() instanceof Fisheye;
        k = isFisheye ? ((Fisheye) rays.camera().lens()).k() : 1;
        isPinhole = k == 1;
    }

    /** Begins a block, whose first pixel is given. */
    void begin(int blockLeft, int blockTop) {
        left = blockLeft;
        top = blockTop;
        Arrays.fill(isKnown, false);
    }

    /**
     * Turns the cone to the rays through a square of the block, its border included. Coordinates count from the block's
     * corner, in quarters of a pixel.
     *
     * @param around what a square around this one shows
     */
    View aim(int x0, int y0, int x1, int y1, View around) {
        return isPinhole ? aimThroughPinhole(x0, y0, x1, y1)
            : aimThroughFisheye(left + x0 / (double) PARTS, top + y0 / (double) PARTS, left + x1 / (double) PARTS,
                top + y1 / (double) PARTS, around);
    }

    private View aimThroughPinhole(int x0, int y0, int x1, int y1) {
        int a = corner(x0, y0);
        int b = corner(x1, y0);
        int c = corner(x0, y1);
        int d = corner(x1, y1);
        double x = corners[a] + corners[b] + corners[c] + corners[d];
        double y = corners[a + 1] + corners[b + 1] + corners[c + 1] + corners[d + 1];
        double z = corners[a + 2] + corners[b + 2] + corners[c + 2] + corners[d + 2];
        double factor = 1 / Math.sqrt(x * x + y * y + z * z);
        axisX = factor * x;
        axisY = factor * y;
        axisZ = factor * z;
        double least = Math.min(Math.min(along(a), along(b)), Math.min(along(c), along(d)));
        if (!(least > SMALLEST_COSINE)) {
            return View.TOO_WIDE;
        }
        double square = Math.max(Math.max(squaredSine(a), squaredSine(b)), Math.max(squaredSine(c), squaredSine(d)));
        setSine(Math.sqrt(square) + ROUNDING);
        return View.LIT;
    }

    /** Turns the cone around a square to that around the circle inside the square, but for the square's distortion. */
    void narrow() {
        setSine(INSIDE * sine);
    }

    private void setSine(double value) {
        sine = value;
        cosine = Math.sqrt(1 - sine * sine);
    }

    /** Where the direction through a corner of a pixel is; it is worked out when it is first asked for. */
    private int corner(int x, int y) {
        int number = y * CORNERS_IN_A_ROW + x;
        if (!isKnown[number]) {
            isKnown[number] = true;
            rays.start(left + x / (double) PARTS, top + y / (double) PARTS, ray);
            corners[3 * number] = ray.dx();
            corners[3 * number + 1] = ray.dy();
            corners[3 * number + 2] = ray.dz();
        }
        return 3 * number;
    }

    private double along(int at) {
        return axisX * corners[at] + axisY * corners[at + 1] + axisZ * corners[at + 2];
    }

    private double squaredSine(int at) {
        double x = axisY * corners[at + 2] - axisZ * corners[at + 1];
        double y = axisZ * corners[at] - axisX * corners[at + 2];
        double z = axisX * corners[at + 1] - axisY * corners[at];
        return x * x + y * y + z * z;
    }

    private View aimThroughFisheye(double x0, double y0, double x1, double y1, View around) {
        double nearX = Math.max(x0, Math.min(x1, 0.5 * rays.width()));
        double nearY = Math.max(y0, Math.min(y1, 0.5 * rays.height()));
        double farX = x0 + x1 > rays.width() ? x1 : x0;
        double farY = y0 + y1 > rays.height() ? y1 : y0;
        double near = (1 - ROUNDING) * rays.radius(nearX, nearY);
        double far = (1 + ROUNDING) * rays.radius(farX, farY);
        if (!(near < Double.POSITIVE_INFINITY)) {
            return View.TOO_WIDE;
        }
        Fisheye lens = (Fisheye) rays.camera().lens();
        if (around != View.LIT && !(lens.incidentAngle(near) < (1 + ROUNDING) * (Math.PI / 2))) {
            return View.BLACK;
        }
        boolean isLit = around == View.LIT || lens.incidentAngle(far) < (1 - ROUNDING) * (Math.PI / 2);
        double width = x1 - x0;
        double height = y1 - y0;
        double diagonal = LENGTHENED * Math.sqrt(width * width + height * height) / rays.pixelsPerScreenDistance();
        double angle = rate(near, isLit ? far : Math.min(far, borderRadius())) * (isLit ? diagonal / 2 : diagonal);
        boolean isStarted = isLit ? rays.start(0.5 * (x0 + x1), 0.5 * (y0 + y1), ray) : rays.start(nearX, nearY, ray);
        if (!(angle < WIDEST) || !isStarted) {
            return View.TOO_WIDE;
        }
        axisX = ray.dx();
        axisY = ray.dy();
        axisZ = ray.dz();
        setSine(angle + (1 + angle / diagonal) * ROUNDING);   // a sine is below its angle
        return isLit ? View.LIT : View.BORDER;
    }

    /** The greatest rate at which directions turn between two radii, in radians for a screen distance; may be infinite. */
    private double rate(double near, double far) {
        if (k < 0) {
            double squaredCosine = 1 - k * far * (k * far);
            return squaredCosine > LEAST_SQUARED_COSINE ? 1 / Math.sqrt(squaredCosine) : Double.POSITIVE_INFINITY;
        }
        return Math.max(1 / (1 + k * near * (k * near)), Math.min(1, 1 / near));
    }

    /** From where on all is black, as a radius that is certainly not too small; for k below 0. */
    private double borderRadius() {
        return k < 0 ? (1 + ROUNDING) * StrictMath.sin(-k * (Math.PI / 2)) / -k : Double.POSITIVE_INFINITY;
    }

    /** The length of a vector's component along the axis, below 0 if it goes back. */
    double along(double x, double y, double z) {
        return x * axisX + y * axisY + z * axisZ;
    }

    /** The length of a vector's component across the axis. */
    double across(double x, double y, double z) {
        double ax = y * axisZ - z * axisY;
        double ay = z * axisX - x * axisZ;
        double az = x * axisY - y * axisX;
        return Math.sqrt(ax * ax + ay * ay + az * az);
    }

    /**
     * The least product of a vector with the cone's directions, which are of length 1, given its components along and across
     * the axis. Where this is not above 0, it may be more than the least.
     */
    double leastProduct(double along, double across) {
        return along * cosine - across * sine;
    }

    /** The greatest product; a vector inside the cone has one with its own direction, which is its length. */
    double mostProduct(double along, double across, double length) {
        return across * cosine < along * sine ? length : along * cosine + across * sine;
    }

    /** How far the end of a vector from the eye is beyond the mantle; below 0 inside the cone. */
    double beyond(double along, double across) {
        return across * cosine - along * sine;
    }
}
