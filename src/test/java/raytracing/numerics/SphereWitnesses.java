package raytracing.numerics;

import raytracing.surface.Sphere;

/** Sphere formulas that lose, and one that wins at any price: what ours is measured against. */
final class SphereWitnesses {
    private SphereWitnesses() {
    }

    static double textbook(double ox, double oy, double oz, double dx, double dy, double dz,
                           double cx, double cy, double cz, double r) {
        double x = ox - cx;
        double y = oy - cy;
        double z = oz - cz;
        double a = dx * dx + dy * dy + dz * dz;
        double b = 2 * (x * dx + y * dy + z * dz);
        double c = x * x + y * y + z * z - r * r;
        double discriminant = b * b - 4 * a * c;
        if (discriminant < 0) {
            return Formula.MISS;
        }
        double root = Math.sqrt(discriminant);
        return smallestAboveZero((-b - root) / (2 * a), (-b + root) / (2 * a));
    }

    static double halfB(double ox, double oy, double oz, double dx, double dy, double dz,
                        double cx, double cy, double cz, double r) {
        double x = ox - cx;
        double y = oy - cy;
        double z = oz - cz;
        double a = dx * dx + dy * dy + dz * dz;
        double b = -(x * dx + y * dy + z * dz);
        double c = x * x + y * y + z * z - r * r;
        double discriminant = b * b - a * c;
        if (discriminant < 0) {
            return Formula.MISS;
        }
        double root = Math.sqrt(discriminant);
        return smallestAboveZero((b - root) / a, (b + root) / a);
    }

    static double closestApproach(double ox, double oy, double oz, double dx, double dy, double dz,
                                  double cx, double cy, double cz, double r) {
        double x = ox - cx;
        double y = oy - cy;
        double z = oz - cz;
        double c = x * x + y * y + z * z - r * r;
        return fromClosestApproach(x, y, z, dx, dy, dz, r, c);
    }

    static double compensated(double ox, double oy, double oz, double dx, double dy, double dz,
                              double cx, double cy, double cz, double r) {
        double x = ox - cx;
        double y = oy - cy;
        double z = oz - cz;
        double differences = x * Rounding.ofSum(ox, -cx) + y * Rounding.ofSum(oy, -cy) + z * Rounding.ofSum(oz, -cz);
        return fromClosestApproach(x, y, z, dx, dy, dz, r, compensatedC(x, y, z, r) + 2 * differences);
    }

    /** x x + y y + z z - r r, and then all that its roundings left over. */
    private static double compensatedC(double x, double y, double z, double r) {
        double xy = x * x + y * y;
        double xyz = xy + z * z;
        double products = Rounding.ofProduct(x, x) + Rounding.ofProduct(y, y) + Rounding.ofProduct(z, z)
            - Rounding.ofProduct(r, r);
        double sums = Rounding.ofSum(x * x, y * y) + Rounding.ofSum(xy, z * z) + Rounding.ofSum(xyz, -(r * r));
        return xyz - r * r + (products + sums);
    }

    private static double fromClosestApproach(double x, double y, double z, double dx, double dy, double dz,
                                              double r, double c) {
        double a = dx * dx + dy * dy + dz * dz;
        double b = -(x * dx + y * dy + z * dz);
        double foot = b / a;
        double lx = x + foot * dx;
        double ly = y + foot * dy;
        double lz = z + foot * dz;
        double squaredHalfChord = r * r - (lx * lx + ly * ly + lz * lz);
        if (squaredHalfChord < 0) {
            return Formula.MISS;
        }
        double root = Math.sqrt(a * squaredHalfChord);
        double q = b < 0 ? b - root : b + root;
        return smallestAboveZero(c / q, q / a);
    }

    static double doubleDouble(double ox, double oy, double oz, double dx, double dy, double dz,
                               double cx, double cy, double cz, double r) {
        DoubleDoubleVector fromCentre = DoubleDoubleVector.between(cx, cy, cz, ox, oy, oz);
        DoubleDoubleVector d = DoubleDoubleVector.of(dx, dy, dz);
        DoubleDouble a = d.dot(d);
        DoubleDouble b = fromCentre.dot(d).negated();
        DoubleDouble c = fromCentre.dot(fromCentre).minus(DoubleDouble.product(r, r));
        DoubleDouble discriminant = b.times(b).minus(a.times(c));
        if (discriminant.isNegative()) {
            return Formula.MISS;
        }
        DoubleDouble root = discriminant.squareRoot();
        DoubleDouble q = b.isNegative() ? b.minus(root) : b.plus(root);
        return smallestAboveZero(c.dividedBy(q).high(), q.dividedBy(a).high());
    }

    private static double smallestAboveZero(double s, double t) {
        double first = s < t ? s : t;
        double last = s < t ? t : s;
        if (first > 0) {
            return first;
        }
        return last > 0 ? last : Formula.MISS;
    }
}
