package raytracing.numerics;

import raytracing.surface.Box;

/** Box formulas that lose, and one that wins at any price: what ours is measured against. */
final class BoxWitnesses {
    private static final DoubleDouble EVER = DoubleDouble.of(Double.POSITIVE_INFINITY);

    private BoxWitnesses() {
    }

    /** A ray in the plane of a face asks for 0 times infinity; Math.min and Math.max pass the NaN on, so it misses. */
    static double reciprocal(double ox, double oy, double oz, double dx, double dy, double dz,
                             double cx, double cy, double cz, double edge) {
        double h = edge / 2;
        double lowX = (cx - h - ox) * (1 / dx);
        double highX = (cx + h - ox) * (1 / dx);
        double lowY = (cy - h - oy) * (1 / dy);
        double highY = (cy + h - oy) * (1 / dy);
        double lowZ = (cz - h - oz) * (1 / dz);
        double highZ = (cz + h - oz) * (1 / dz);
        double enter = Math.max(Math.min(lowX, highX), Math.max(Math.min(lowY, highY), Math.min(lowZ, highZ)));
        double exit = Math.min(Math.max(lowX, highX), Math.min(Math.max(lowY, highY), Math.max(lowZ, highZ)));
        return firstAboveZero(enter, exit);
    }

    static double reciprocalOrdered(double ox, double oy, double oz, double dx, double dy, double dz,
                                    double cx, double cy, double cz, double edge) {
        double h = edge / 2;
        double lowX = (cx - h - ox) * (1 / dx);
        double highX = (cx + h - ox) * (1 / dx);
        double lowY = (cy - h - oy) * (1 / dy);
        double highY = (cy + h - oy) * (1 / dy);
        double lowZ = (cz - h - oz) * (1 / dz);
        double highZ = (cz + h - oz) * (1 / dz);
        double enter = later(earlier(lowX, highX), later(earlier(lowY, highY), earlier(lowZ, highZ)));
        double exit = earlier(later(lowX, highX), earlier(later(lowY, highY), later(lowZ, highZ)));
        return firstAboveZero(enter, exit);
    }

    static double division(double ox, double oy, double oz, double dx, double dy, double dz,
                           double cx, double cy, double cz, double edge) {
        double h = edge / 2;
        if (isBeside(cx - h - ox, cx + h - ox, dx) || isBeside(cy - h - oy, cy + h - oy, dy)
                || isBeside(cz - h - oz, cz + h - oz, dz)) {
            return Formula.MISS;
        }
        double enter = later(enter(cx - h - ox, cx + h - ox, dx),
            later(enter(cy - h - oy, cy + h - oy, dy), enter(cz - h - oz, cz + h - oz, dz)));
        double exit = earlier(exit(cx - h - ox, cx + h - ox, dx),
            earlier(exit(cy - h - oy, cy + h - oy, dy), exit(cz - h - oz, cz + h - oz, dz)));
        return firstAboveZero(enter, exit);
    }

    /** The faces stay at the real numbers centre -/+ half edge: three numbers are summed, and rounded once. */
    static double compensated(double ox, double oy, double oz, double dx, double dy, double dz,
                              double cx, double cy, double cz, double edge) {
        double h = edge / 2;
        double lowX = sum(cx, -ox, -h);
        double highX = sum(cx, -ox, h);
        double lowY = sum(cy, -oy, -h);
        double highY = sum(cy, -oy, h);
        double lowZ = sum(cz, -oz, -h);
        double highZ = sum(cz, -oz, h);
        if (isBeside(lowX, highX, dx) || isBeside(lowY, highY, dy) || isBeside(lowZ, highZ, dz)) {
            return Formula.MISS;
        }
        double enter = later(enter(lowX, highX, dx), later(enter(lowY, highY, dy), enter(lowZ, highZ, dz)));
        double exit = earlier(exit(lowX, highX, dx), earlier(exit(lowY, highY, dy), exit(lowZ, highZ, dz)));
        return firstAboveZero(enter, exit);
    }

    private static double sum(double a, double b, double c) {
        double ab = a + b;
        return ab + c + (Rounding.ofSum(a, b) + Rounding.ofSum(ab, c));
    }

    private static boolean isBeside(double low, double high, double d) {
        return d == 0 && !(low <= 0 && high >= 0);
    }

    private static double enter(double low, double high, double d) {
        return d == 0 ? Double.NEGATIVE_INFINITY : (d > 0 ? low : high) / d;
    }

    private static double exit(double low, double high, double d) {
        return d == 0 ? Double.POSITIVE_INFINITY : (d > 0 ? high : low) / d;
    }

    private static double firstAboveZero(double enter, double exit) {
        if (!(enter <= exit)) {
            return Formula.MISS;
        }
        if (enter > 0) {
            return enter;
        }
        return exit > 0 ? exit : Formula.MISS;
    }

    private static double later(double s, double t) {
        return s > t ? s : t;
    }

    private static double earlier(double s, double t) {
        return s < t ? s : t;
    }

    static double doubleDouble(double ox, double oy, double oz, double dx, double dy, double dz,
                               double cx, double cy, double cz, double edge) {
        DoubleDoubleVector toCentre = DoubleDoubleVector.between(ox, oy, oz, cx, cy, cz);
        DoubleDouble h = DoubleDouble.of(edge / 2);
        if (isBeside(toCentre.x(), dx, h) || isBeside(toCentre.y(), dy, h) || isBeside(toCentre.z(), dz, h)) {
            return Formula.MISS;
        }
        DoubleDouble enter = later(enter(toCentre.x(), dx, h),
            later(enter(toCentre.y(), dy, h), enter(toCentre.z(), dz, h)));
        DoubleDouble exit = earlier(exit(toCentre.x(), dx, h),
            earlier(exit(toCentre.y(), dy, h), exit(toCentre.z(), dz, h)));
        return exit.isLessThan(enter) ? Formula.MISS : firstAboveZero(enter.high(), exit.high());
    }

    private static boolean isBeside(DoubleDouble toCentre, double d, DoubleDouble h) {
        return d == 0 && (toCentre.plus(h).isNegative() || toCentre.minus(h).isPositive());
    }

    private static DoubleDouble enter(DoubleDouble toCentre, double d, DoubleDouble h) {
        return d == 0 ? EVER.negated()
            : (d > 0 ? toCentre.minus(h) : toCentre.plus(h)).dividedBy(DoubleDouble.of(d));
    }

    private static DoubleDouble exit(DoubleDouble toCentre, double d, DoubleDouble h) {
        return d == 0 ? EVER : (d > 0 ? toCentre.plus(h) : toCentre.minus(h)).dividedBy(DoubleDouble.of(d));
    }

    private static DoubleDouble later(DoubleDouble s, DoubleDouble t) {
        return t.isLessThan(s) ? s : t;
    }

    private static DoubleDouble earlier(DoubleDouble s, DoubleDouble t) {
        return s.isLessThan(t) ? s : t;
    }
}
