package raytracing.surface;

import java.util.Optional;
import raytracing.math.Dyadic;
import raytracing.math.DyadicVector;
import raytracing.math.Surd;
import raytracing.math.Vector;

/**
 * What doubles leave open about a plane, in exact numbers: origins close to the plane, rays nearly along it,
 * sizes near the ends of the range, and crossings close to others. The formulas are those of {@link Plane}.
 *
 * @param normal as the scene wrote it
 * @param offset of its points: P . normal = offset
 */
record ExactPlane(DyadicVector normal, Dyadic offset) {
    static ExactPlane of(Plane plane) {
        return new ExactPlane(DyadicVector.of(plane.normal()), Dyadic.of(plane.offset()));
    }

    /** The first crossing of a ray that does not start on this plane by its number. */
    Optional<Surd> firstCrossing(Ray ray, int number) {
        RayOrigin origin = ray.origin;
        Dyadic gap = gap(origin.point(), origin.error());
        Dyadic approach = normal.dot(DyadicVector.of(ray.direction()));
        if (gap.signum() == 0) {
            return side(origin, number) * approach.signum() < 0 ? Optional.of(Surd.ZERO) : Optional.empty();
        }
        return gap.signum() * approach.signum() > 0 ? Optional.of(Surd.quotient(gap, approach)) : Optional.empty();
    }

    /**
     * On which side a point lies: 1 where the normal points, -1 on the other, 0 if it is on the plane as far as it is
     * known and was not seen from off it.
     */
    int side(RayOrigin point, int number) {
        int there = side(point.point(), point.error());
        if (there != 0) {
            return there;
        }
        return switch (point.sideSeenFrom(number)) {
            case OUTWARD -> 1;
            case INWARD -> -1;
            case ELSEWHERE -> side(point.seenFrom(), point.seenFromError());
        };
    }

    /** The same for a point of which only the place is known. */
    int side(Vector point, double error) {
        return -gap(point, error).signum();
    }

    /** offset - P . normal: above 0 on the side where the normal does not point. */
    Dyadic gap(DyadicVector point) {
        return offset.minus(normal.dot(point));
    }

    /** The same, or 0 if P is on the plane within its error. */
    private Dyadic gap(Vector point, double error) {
        Dyadic gap = gap(DyadicVector.of(point));
        return gap.abs().compareTo(Dyadic.of(error).times(normal.sumOfSizes())) <= 0 ? Dyadic.ZERO : gap;
    }
}
