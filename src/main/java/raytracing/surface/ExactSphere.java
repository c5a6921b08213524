package raytracing.surface;

import java.util.Optional;
import raytracing.math.Dyadic;
import raytracing.math.DyadicVector;
import raytracing.math.Surd;
import raytracing.math.Vector;

/**
 * What doubles leave open about a sphere, in exact numbers: origins close to the wall, grazing rays, sizes near
 * the ends of the range, and crossings close to others. The formulas are those of {@link Sphere}, but for the
 * discriminant b b - a power, which needs fewer digits and is the same number.
 *
 * @param centre its middle
 * @param radius above 0
 */
record ExactSphere(DyadicVector centre, Dyadic radius) {
    private static final Dyadic TWO = Dyadic.of(2);

    static ExactSphere of(Sphere sphere) {
        return new ExactSphere(DyadicVector.of(sphere.centre()), Dyadic.of(sphere.radius()));
    }

    /** The first crossing of a ray that does not leave this sphere outwards. */
    Optional<Surd> firstCrossing(Ray ray, int number) {
        RayOrigin origin = ray.origin;
        DyadicVector f = fromCentre(origin.point());
        DyadicVector d = DyadicVector.of(ray.direction());
        Dyadic b = f.dot(d).negated();
        Dyadic power = power(f);
        boolean isOnWall = origin.surface == number || isOnWall(power, f, origin.error());
        int side = isOnWall ? sideOnWall(origin, number) : power.signum();
        if (side >= 0 && b.signum() <= 0) {
            return Optional.empty();
        }
        if (isOnWall) {
            // at once: from outside going in, or from inside going out; else across, as the origin's power is 0
            return Optional.of(side > 0 || b.signum() <= 0 ? Surd.ZERO : Surd.quotient(TWO.times(b), d.dot(d)));
        }
        Dyadic a = d.dot(d);
        Dyadic discriminant = b.times(b).minus(a.times(power));
        if (discriminant.signum() < 0) {
            return Optional.empty();
        }
        return Optional.of(new Surd(b, side > 0 ? discriminant.negated() : discriminant, a));
    }

    /** Whether a segment that does not start on this sphere by its number crosses the wall. */
    boolean isCrossed(Segment segment, int number) {
        RayOrigin start = segment.start;
        DyadicVector f = fromCentre(start.point());
        DyadicVector g = fromCentre(segment.end());
        Dyadic power = power(f);
        boolean startsOnWall = isOnWall(power, f, start.error());
        int startSide = startsOnWall ? sideOnWall(start, number) : power.signum();
        int endSide = side(segment.end(), segment.endError);
        if (startSide < 0 || endSide < 0) {
            return startSide * endSide < 0;
        }
        if (startSide == 0 && endSide == 0) {
            return false;                    // a chord from wall to wall, its ends not counted
        }
        DyadicVector d = g.minus(f);
        Dyadic b = f.dot(d);
        if (startsOnWall) {
            return b.signum() < 0;           // goes in
        }
        boolean endsOutwards = g.dot(d).signum() > 0;
        return endSide == 0 ? endsOutwards
            : endsOutwards && b.signum() < 0 && b.times(b).compareTo(d.dot(d).times(power)) >= 0;
    }

    /**
     * How a point lies to the sphere: 1 outside, -1 inside, 0 if it is on the wall within its error and was seen from a
     * point on the wall too, or along a line that touches the wall there.
     */
    int side(RayOrigin point, int number) {
        int there = point.surface() == number ? 0 : side(point.point(), point.error());
        return there == 0 ? sideOnWall(point, number) : there;
    }

    /** The same for a point on the wall, by the way in which it was seen. */
    private int sideOnWall(RayOrigin point, int number) {
        return switch (point.surface() == number ? point.side() : point.sideSeenFrom(number)) {
            case OUTWARD -> 1;
            case INWARD -> -1;
            case ELSEWHERE -> sideSeen(point);
        };
    }

    private int sideSeen(RayOrigin point) {
        int sideSeenFrom = side(point.seenFrom(), point.seenFromError());
        if (sideSeenFrom <= 0) {
            return sideSeenFrom;
        }
        DyadicVector from = fromCentre(point.seenFrom());
        DyadicVector to = fromCentre(point.point());
        DyadicVector line = to.minus(from);
        int alongNormal = to.dot(line).signum();
        if (alongNormal <= 0) {
            return -alongNormal;
        }
        // going out, the line has been inside before, unless all of it passes outside by less than a rounding
        Dyadic b = from.dot(line);
        return b.times(b).compareTo(line.dot(line).times(power(from))) >= 0 ? -1 : 1;
    }

    /** How a point of which only the place is known lies to the sphere: 1 outside, -1 inside, 0 on the wall. */
    int side(Vector point, double error) {
        DyadicVector fromCentre = fromCentre(point);
        Dyadic power = power(fromCentre);
        return isOnWall(power, fromCentre, error) ? 0 : power.signum();
    }

    private DyadicVector fromCentre(Vector point) {
        return DyadicVector.of(point).minus(centre);
    }

    /** The power of a point: its squared distance from the centre minus the squared radius. */
    private Dyadic power(DyadicVector fromCentre) {
        return fromCentre.dot(fromCentre).minus(radius.times(radius));
    }

    /**
     * Whether a point is on the wall within its error. The power's slope along an axis is twice the point's coordinate from
     * the centre.
     */
    private static boolean isOnWall(Dyadic power, DyadicVector fromCentre, double error) {
        return power.abs().compareTo(TWO.times(Dyadic.of(error)).times(fromCentre.sumOfSizes())) <= 0;
    }
}
