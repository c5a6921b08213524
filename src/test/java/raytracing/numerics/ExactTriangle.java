package raytracing.numerics;

import java.util.Optional;
import raytracing.math.Vector;
import raytracing.surface.Triangle;

/**
 * Ray against triangle in exact arithmetic: o + t d = a + v (b - a) + w (c - a), solved by Cramer's rule. The product compares
 * the volumes of the three edges instead.
 *
 * @param a a corner
 * @param u the way from there to the second
 * @param v the way from there to the third
 */
record ExactTriangle(ExactPoint a, ExactPoint u, ExactPoint v) {
    static ExactTriangle of(Triangle triangle) {
        return between(triangle.a(), triangle.b(), triangle.c());
    }

    static ExactTriangle between(Vector a, Vector b, Vector c) {
        ExactPoint first = ExactPoint.of(a);
        return new ExactTriangle(first, ExactPoint.of(b).minus(first), ExactPoint.of(c).minus(first));
    }

    /** Whether its corners are on a line. */
    boolean isEmpty() {
        return u.cross(v).isZero();
    }

    /** The crossing above 0 of a ray, or nothing; the border counts, and a ray in the plane crosses nothing. */
    Optional<ExactCrossing> firstCrossing(Vector origin, Vector direction) {
        return crossing(ExactPoint.of(origin), ExactPoint.of(direction)).flatMap(ExactCrossing::ifAboveZero);
    }

    /** The crossing of a line, wherever it is. */
    private Optional<ExactCrossing> crossing(ExactPoint origin, ExactPoint direction) {
        ExactPoint p = direction.cross(v);
        ExactNumber determinant = u.dot(p);
        ExactPoint s = origin.minus(a);
        ExactPoint q = s.cross(u);
        int sign = determinant.signum();
        ExactNumber alongU = s.dot(p);
        ExactNumber alongV = direction.dot(q);
        boolean isInside = sign * alongU.signum() >= 0 && sign * alongV.signum() >= 0
            && sign * determinant.minus(alongU).minus(alongV).signum() >= 0;
        return sign == 0 || !isInside ? Optional.empty() : Optional.of(ExactCrossing.rational(v.dot(q), determinant));
    }

    /** Whether the open line between two points goes through it. */
    boolean isCrossed(Vector from, Vector to) {
        return isCrossed(ExactPoint.of(from), ExactPoint.of(to));
    }

    boolean isCrossed(ExactPoint from, ExactPoint to) {
        return crossing(from, to.minus(from))
            .filter(crossing -> crossing.p().signum() > 0 && crossing.p().compareTo(crossing.q()) < 0).isPresent();
    }

    /** 1 where the normal u x v points, -1 on the other side, 0 on the plane. */
    int side(ExactPoint point) {
        return u.cross(v).dot(point.minus(a)).signum();
    }
}
