package raytracing.numerics;

import raytracing.math.Vector;

/** A formula for triangles that loses, and one that hardly ever does: what ours is measured against. */
final class TriangleWitnesses {
    private TriangleWitnesses() {
    }

    /** The first crossing by the algorithm of that name, as the other shapes have them. */
    static double firstCrossing(String algorithm, TriangleQuery query) {
        return switch (algorithm) {
            case "TEXTBOOK" -> textbook(query);
            case "OURS" -> query.found();
            default -> doubleDouble(query);
        };
    }

    /** Moeller and Trumbore, without their epsilon. */
    static double textbook(TriangleQuery query) {
        Vector u = query.b().minus(query.a());
        Vector v = query.c().minus(query.a());
        Vector p = query.direction().cross(v);
        double determinant = u.dot(p);
        Vector s = query.origin().minus(query.a());
        Vector q = s.cross(u);
        double alongU = s.dot(p) / determinant;
        double alongV = query.direction().dot(q) / determinant;
        double t = v.dot(q) / determinant;
        return alongU >= 0 && alongV >= 0 && alongU + alongV <= 1 && t > 0 ? t : Formula.MISS;
    }

    private static DoubleDoubleVector between(Vector from, Vector to) {
        return DoubleDoubleVector.between(from.x(), from.y(), from.z(), to.x(), to.y(), to.z());
    }

    private static double doubleDouble(TriangleQuery query) {
        DoubleDoubleVector direction = between(Vector.ZERO, query.direction());
        DoubleDoubleVector u = between(query.a(), query.b());
        DoubleDoubleVector v = between(query.a(), query.c());
        DoubleDoubleVector p = direction.cross(v);
        DoubleDouble determinant = u.dot(p);
        DoubleDoubleVector s = between(query.a(), query.origin());
        DoubleDoubleVector q = s.cross(u);
        DoubleDouble alongU = s.dot(p).dividedBy(determinant);
        DoubleDouble alongV = direction.dot(q).dividedBy(determinant);
        double t = v.dot(q).dividedBy(determinant).high();
        boolean isInside = !alongU.isNegative() && !alongV.isNegative()
            && !DoubleDouble.of(1).isLessThan(alongU.plus(alongV));
        return isInside && t > 0 ? t : Formula.MISS;
    }
}
