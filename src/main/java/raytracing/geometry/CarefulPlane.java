package raytracing.geometry;

import raytracing.math.DoubleDouble;
import raytracing.math.DoubleDoubleVector;
import raytracing.math.Dyadic;
import raytracing.math.DyadicVector;
import raytracing.math.Vector;

/**
 * The questions about planes that doubles leave open, in double-doubles: origins close to the plane, rays nearly along
 * it, sizes near the ends of the range. Where 106 bits leave a doubt too, exact numbers take over for that one number.
 * So every decision is that of real arithmetic on the doubles given, provided the sizes of lengths differ by less than
 * 2^400. The formulas are those of {@link PlaneKernel}.
 */
final class CarefulPlane {
    /** A sum's error, relative to the sum of its terms' sizes: below 2^-100 (proved), and then negligible above this. */
    private static final double CLEAR = 0x1p-46;

    private CarefulPlane() {
    }

    /**
     * {@link PlaneKernel#firstCrossing}, for the rays that it leaves open. Where sizes near the ends of the range are the
     * reason, it is asked again about the same in an ordinary size, where doubles answer most.
     */
    static double firstCrossing(double ox, double oy, double oz, double dx, double dy, double dz,
                                double originError, double nx, double ny, double nz, double offset) {
        Vector origin = new Vector(ox, oy, oz);
        Vector direction = new Vector(dx, dy, dz);
        Vector normal = new Vector(nx, ny, nz);
        int slope = Scaling.exponent(0, normal);
        int length = lengthExponent(origin, slope, offset);
        int step = Scaling.exponent(0, direction);
        if (slope == 0 && length == 0 && step == 0) {
            return firstCrossing(origin, direction, originError, normal, offset);
        }
        Vector o = Scaling.down(origin, length);
        Vector d = Scaling.down(direction, step);
        Vector n = Scaling.down(normal, slope);
        return Scaling.upPositive(PlaneKernel.firstCrossing(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(),
            Scaling.down(originError, length), n.x(), n.y(), n.z(), Scaling.down(offset, slope + length)), length - step);
    }

    private static double firstCrossing(Vector origin, Vector direction, double originError, Vector normal,
                                        double offset) {
        DoubleDouble gap = gap(origin, originError, normal, offset);
        DoubleDouble approach = approach(normal, direction);
        return gap.sign() * approach.sign() > 0 ? gap.high() / approach.high() : Surface.MISS;
    }

    /** {@link PlaneKernel#crossesBetween}, for the lines that it leaves open. */
    static boolean crossesBetween(double px, double py, double pz, double pointError,
                                  double qx, double qy, double qz, double endError,
                                  double nx, double ny, double nz, double offset) {
        Vector normal = new Vector(nx, ny, nz);
        return side(new Vector(px, py, pz), pointError, normal, offset)
            * side(new Vector(qx, qy, qz), endError, normal, offset) < 0;
    }

    /** How a point lies to a plane: 1 where N . P is below c, -1 above, 0 on it as far as the point is known. */
    private static int side(Vector point, double pointError, Vector normal, double offset) {
        int slope = Scaling.exponent(0, normal);
        int length = lengthExponent(point, slope, offset);
        return gap(Scaling.down(point, length), Scaling.down(pointError, length), Scaling.down(normal, slope),
            Scaling.down(offset, slope + length)).sign();
    }

    private static int lengthExponent(Vector point, int slope, double offset) {
        int ofPoint = Scaling.exponent(0, point);
        return offset == 0 ? ofPoint : Math.max(ofPoint, Scaling.exponent(offset) - slope);
    }

    /** c - N . P, or 0 if the point is on the plane as far as it is known. */
    private static DoubleDouble gap(Vector point, double pointError, Vector normal, double offset) {
        double spread = pointError * (Math.abs(normal.x()) + Math.abs(normal.y()) + Math.abs(normal.z()));
        DoubleDouble gap = sum(normal, point, -offset).negated();
        if (Math.abs(gap.high()) <= spread) {
            return DoubleDouble.ZERO;
        }
        return isClear(gap, normal, point, offset) ? gap : exactSum(normal, point, -offset).negated();
    }

    private static DoubleDouble approach(Vector normal, Vector direction) {
        DoubleDouble approach = sum(normal, direction, 0);
        return isClear(approach, normal, direction, 0) ? approach : exactSum(normal, direction, 0);
    }

    /** v . w + s. */
    private static DoubleDouble sum(Vector v, Vector w, double s) {
        return DoubleDoubleVector.of(v).dot(DoubleDoubleVector.of(w)).plus(new DoubleDouble(s, 0));
    }

    private static boolean isClear(DoubleDouble sum, Vector v, Vector w, double s) {
        double size = Math.abs(v.x() * w.x()) + Math.abs(v.y() * w.y()) + Math.abs(v.z() * w.z()) + Math.abs(s);
        return Math.abs(sum.high()) > CLEAR * size;
    }

    private static DoubleDouble exactSum(Vector v, Vector w, double s) {
        return DoubleDouble.nearest(DyadicVector.of(v).dot(DyadicVector.of(w)).plus(Dyadic.of(s)));
    }
}
