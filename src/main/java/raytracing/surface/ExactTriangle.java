package raytracing.surface;

import java.util.Optional;
import raytracing.math.Dyadic;
import raytracing.math.DyadicVector;
import raytracing.math.Surd;
import raytracing.math.Vector;

/**
 * What doubles leave open about a triangle, in exact numbers: lines through edges and corners, origins on it, rays nearly
 * along its plane, needles, sizes near the ends of the range, and crossings close to others. The formulas are those of {@link
 * Triangle}.
 *
 * <p>A point touches the triangle if it is on the plane within its error, and so near to each edge or within it, and in the
 * box around the corners. It then lies as if it had been moved by next to nothing towards the place from which it was seen:
 * that is its side, and for an edge that it is on, the volume with that place counts. So where a mesh is bent outwards, a
 * touched neighbour hides nothing; where it is bent inwards, the neighbour hides what is behind it.
 *
 * @param a a corner, as the others
 * @param plane through them; its normal is (b - a) x (c - a)
 */
record ExactTriangle(DyadicVector a, DyadicVector b, DyadicVector c, ExactPlane plane) {
    static ExactTriangle of(Triangle triangle) {
        DyadicVector a = DyadicVector.of(triangle.a());
        DyadicVector b = DyadicVector.of(triangle.b());
        DyadicVector c = DyadicVector.of(triangle.c());
        DyadicVector normal = b.minus(a).cross(c.minus(a));
        return new ExactTriangle(a, b, c, new ExactPlane(normal, normal.dot(a)));
    }

    static boolean areOnALine(Vector a, Vector b, Vector c) {
        DyadicVector exactA = DyadicVector.of(a);
        return DyadicVector.of(b).minus(exactA).cross(DyadicVector.of(c).minus(exactA)).isZero();
    }

    /** The normal, each part rounded once, at a size near 1. */
    Vector direction() {
        return plane.normal().direction();
    }

    /** The first crossing of a ray that does not start on this triangle by its number. */
    Optional<Surd> firstCrossing(Ray ray, int number) {
        RayOrigin origin = ray.origin;
        DyadicVector direction = DyadicVector.of(ray.direction());
        Dyadic approach = plane.normal().dot(direction);
        if (touches(origin.point(), origin.error())) {
            boolean goesThrough = plane.side(origin, number) * approach.signum() < 0
                && passesTouchedEdges(origin, direction, approach.signum());
            return goesThrough ? Optional.of(Surd.ZERO) : Optional.empty();
        }
        DyadicVector start = DyadicVector.of(origin.point());
        Dyadic gap = plane.gap(start);
        return gap.signum() * approach.signum() > 0 && passesEdges(start, direction, approach.signum())
            ? Optional.of(Surd.quotient(gap, approach)) : Optional.empty();
    }

    /** Whether a segment that does not start on this triangle by its number crosses it between its ends. */
    boolean isCrossed(Segment segment, int number) {
        RayOrigin origin = segment.start;
        DyadicVector end = DyadicVector.of(segment.end());
        int endSide = endSide(segment);
        if (touches(origin.point(), origin.error())) {
            return plane.side(origin, number) * endSide < 0
                && passesTouchedEdges(origin, end.minus(DyadicVector.of(origin.seenFrom())), endSide);
        }
        DyadicVector start = DyadicVector.of(origin.point());
        return plane.gap(start).signum() * endSide > 0 && passesEdges(start, end.minus(start), endSide);
    }

    /** On which side of the plane a segment ends; 0 if it touches the triangle there. */
    int endSide(Segment segment) {
        return touches(segment.end(), segment.endError) ? 0 : -plane.gap(DyadicVector.of(segment.end())).signum();
    }

    /** On which side of the plane a point lies, as {@link ExactPlane#side} tells. */
    int side(RayOrigin point, int number) {
        return plane.side(point, number);
    }

    /**
     * Whether a line that goes through the plane goes through the triangle, its border included.
     *
     * @param sign 1 if the line goes through the plane along the normal, -1 if against it
     */
    private boolean passesEdges(DyadicVector start, DyadicVector direction, int sign) {
        return passes(a, b, start, direction, sign) && passes(b, c, start, direction, sign)
            && passes(c, a, start, direction, sign);
    }

    private static boolean passes(DyadicVector from, DyadicVector to, DyadicVector start, DyadicVector direction, int sign) {
        return sign * direction.dot(from.minus(start).cross(to.minus(start))).signum() >= 0;
    }

    /** The same at a point that touches the triangle: edges that it is not on are passed on the inner side. */
    private boolean passesTouchedEdges(RayOrigin point, DyadicVector direction, int sign) {
        return passesIfTouched(a, b, point, direction, sign) && passesIfTouched(b, c, point, direction, sign)
            && passesIfTouched(c, a, point, direction, sign);
    }

    private boolean passesIfTouched(DyadicVector from, DyadicVector to, RayOrigin point, DyadicVector direction, int sign) {
        return !isOn(from, to, point) || passes(from, to, DyadicVector.of(point.seenFrom()), direction, sign);
    }

    /** The edges on which a point lies that touches the triangle, as {@link Triangle#touchedEdges} gives them. */
    int touchedEdges(RayOrigin point) {
        if (!touches(point.point(), point.error())) {
            return Triangle.NOT_TOUCHED;
        }
        return (isOn(a, b, point) ? Triangle.AB : 0) | (isOn(b, c, point) ? Triangle.BC : 0)
            | (isOn(c, a, point) ? Triangle.CA : 0);
    }

    /** Whether a point that touches the triangle is not clearly on the inner side of an edge. */
    private boolean isOn(DyadicVector from, DyadicVector to, RayOrigin point) {
        return inside(from, to, DyadicVector.of(point.point())).compareTo(doubt(from, to, point.error())) <= 0;
    }

    private boolean touches(Vector point, double error) {
        DyadicVector exact = DyadicVector.of(point);
        return plane.side(point, error) == 0 && isInside(a, b, exact, error) && isInside(b, c, exact, error)
            && isInside(c, a, exact, error) && isInside(exact.x(), a.x(), b.x(), c.x(), error)
            && isInside(exact.y(), a.y(), b.y(), c.y(), error) && isInside(exact.z(), a.z(), b.z(), c.z(), error);
    }

    /** Whether a point is on the inner side of an edge or within its error of it. */
    private boolean isInside(DyadicVector from, DyadicVector to, DyadicVector point, double error) {
        return inside(from, to, point).plus(doubt(from, to, error)).signum() >= 0;
    }

    /** How far a point is on the inner side of an edge, seen along the normal, in multiples of both their lengths. */
    private Dyadic inside(DyadicVector from, DyadicVector to, DyadicVector point) {
        return plane.normal().dot(to.minus(from).cross(point.minus(from)));
    }

    /** By how much that changes at most if the point moves by its error. */
    private Dyadic doubt(DyadicVector from, DyadicVector to, double error) {
        return Dyadic.of(error).times(plane.normal().cross(to.minus(from)).sumOfSizes());
    }

    /** Whether a coordinate is between the least and the greatest of three, or within its error of that. */
    private static boolean isInside(Dyadic point, Dyadic first, Dyadic second, Dyadic third, double error) {
        Dyadic low = point.minus(Dyadic.of(error));
        Dyadic high = point.plus(Dyadic.of(error));
        boolean isBelow = high.compareTo(first) < 0 && high.compareTo(second) < 0 && high.compareTo(third) < 0;
        boolean isAbove = low.compareTo(first) > 0 && low.compareTo(second) > 0 && low.compareTo(third) > 0;
        return !isBelow && !isAbove;
    }
}
