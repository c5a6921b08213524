package raytracing.surface;

import java.util.Optional;
import raytracing.math.Dyadic;
import raytracing.math.DyadicVector;
import raytracing.math.Surd;
import raytracing.math.Vector;

/**
 * What doubles leave open about a cube, in exact numbers: rays through edges and corners or in the plane of a face,
 * origins on a face, sizes near the ends of the range, and crossings close to others.
 *
 * @param centre its middle, world axes
 * @param half the edge, above 0
 */
record ExactBox(DyadicVector centre, Dyadic half) {
    private static final int AXES = 3;
    private static final int NONE = -1;
    private static final DyadicVector UPWARDS = DyadicVector.of(new Vector(1, 1, 1));

    static ExactBox of(Box box) {
        return new ExactBox(DyadicVector.of(box.centre()), Dyadic.of(box.edge() / 2));
    }

    /**
     * The two faces on one axis, seen by a ray. The near face is that which the ray passes first, wherever it starts; ways
     * count along the ray.
     *
     * @param speed size of the ray's direction on this axis
     * @param wayToNear from the ray's start to the near face; 0 if it starts on its plane within its error
     * @param sideOfNear 1 if the ray starts before the near face, -1 behind it, 0 on it
     */
    private record Slab(Dyadic speed, Dyadic wayToNear, int sideOfNear, Dyadic wayToFar, int sideOfFar) {
        boolean isCrossed() {
            return speed.signum() != 0;
        }

        /** Whether the ray starts between the faces or on one of them. */
        boolean startsIn() {
            return sideOfNear <= 0 && sideOfFar >= 0;
        }

        boolean startsOnFace() {
            return sideOfNear == 0 || sideOfFar == 0;
        }

        /** Whether the ray is never between the faces after its start. */
        boolean staysOut() {
            return isCrossed() ? sideOfFar <= 0 : !startsIn();
        }

        /** Compares when the ray passes the near face of this slab and that of another; at once and ahead is later. */
        boolean isEnteredAfterEntering(Slab other) {
            int comparison = compare(wayToNear, other, other.wayToNear);
            return comparison > 0 || comparison == 0 && sideOfNear > other.sideOfNear;
        }

        boolean isEnteredAfterLeaving(Slab other) {
            return compare(wayToNear, other, other.wayToFar) > 0;
        }

        boolean isLeftAfterLeaving(Slab other) {
            return compare(wayToFar, other, other.wayToFar) > 0;
        }

        /** Compares way / speed with that of another slab, multiplied out. */
        private int compare(Dyadic way, Slab other, Dyadic otherWay) {
            return way.times(other.speed).compareTo(otherWay.times(speed));
        }

        /** With other sides where the start is on a face. */
        Slab withSides(int near, int far) {
            return new Slab(speed, wayToNear, sideOfNear == 0 ? near : sideOfNear, wayToFar, sideOfFar == 0 ? far : sideOfFar);
        }
    }

    /** The first crossing of a ray that does not leave this cube outwards. */
    Optional<Surd> firstCrossing(Ray ray, int number) {
        Slab[] slabs = slabs(ray.origin, number, DyadicVector.of(ray.direction()));
        if (slabs[0].staysOut() || slabs[1].staysOut() || slabs[2].staysOut()) {
            return Optional.empty();
        }
        Slab left = slabs[left(slabs)];
        if (startsIn(slabs)) {
            return Optional.of(Surd.quotient(left.wayToFar(), left.speed()));
        }
        Slab entered = slabs[entered(slabs)];
        return entered.isEnteredAfterLeaving(left) ? Optional.empty()
            : Optional.of(Surd.quotient(entered.wayToNear(), entered.speed()));
    }

    /** The faces that a ray which meets the cube crosses at once there, as a bit 1 &lt;&lt; axis for each. */
    int axesCrossed(Ray ray, int number) {
        Slab[] slabs = slabs(ray.origin, number, DyadicVector.of(ray.direction()));
        boolean isLeft = startsIn(slabs);
        Slab first = slabs[isLeft ? left(slabs) : entered(slabs)];
        int axes = 0;
        for (int axis = 0; axis < AXES; axis++) {
            Slab slab = slabs[axis];
            if (slab.isCrossed() && !(isLeft ? slab.isLeftAfterLeaving(first) : first.isEnteredAfterEntering(slab))) {
                axes |= 1 << axis;
            }
        }
        return axes;
    }

    /** Whether a segment that does not start on this cube by its number crosses the walls. */
    boolean isCrossed(Segment segment, int number) {
        DyadicVector line = DyadicVector.of(segment.end()).minus(DyadicVector.of(segment.start.point()));
        Slab[] fromStart = slabs(segment.start, number, line);
        Slab[] fromEnd = slabs(segment.end(), segment.endError, line);
        for (int axis = 0; axis < AXES; axis++) {
            if (staysOnOneSide(fromStart[axis], fromEnd[axis])) {
                return false;
            }
        }
        if (startsIn(fromStart) || startsIn(fromEnd)) {
            return startsIn(fromStart) != startsIn(fromEnd);
        }
        for (int entered = 0; entered < AXES; entered++) {
            for (int left = 0; left < AXES; left++) {
                if (fromStart[entered].sideOfNear() > 0 && fromEnd[left].sideOfFar() < 0
                        && fromStart[entered].isEnteredAfterLeaving(fromStart[left])) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Whether both ends of a line lie to one side of the cube on this axis, or one does and the other on its face. */
    private static boolean staysOnOneSide(Slab fromStart, Slab fromEnd) {
        return fromEnd.sideOfNear() > 0 || fromEnd.sideOfNear() == 0 && fromStart.sideOfNear() > 0
            || fromStart.sideOfFar() < 0 || fromStart.sideOfFar() == 0 && fromEnd.sideOfFar() < 0;
    }

    /** How a point lies to the cube: 1 outside, -1 inside, 0 if it is on a face from whose plane it was seen. */
    int side(RayOrigin point, int number) {
        return side(slabs(point, number, UPWARDS));
    }

    /** The same for a point of which only the place is known; 0 on a face. */
    int side(Vector point, double error) {
        return side(slabs(point, error, UPWARDS));
    }

    private static int side(Slab... slabs) {
        int side = -1;
        for (Slab slab : slabs) {
            side = Math.max(side, side(slab));
        }
        return side;
    }

    private static int side(Slab slab) {
        return !slab.startsIn() ? 1 : slab.startsOnFace() ? 0 : -1;
    }

    /** The same for the two faces on one axis: 1 outside, -1 between them, 0 on one of them. */
    int side(RayOrigin point, int number, int axis) {
        return side(slabs(point, number, UPWARDS)[axis]);
    }

    /** A ray's slabs, its start on the sides of the faces that it touches from which it was seen. */
    private Slab[] slabs(RayOrigin start, int number, DyadicVector direction) {
        Slab[] slabs = slabs(start.point(), start.error(), direction);
        if (!startsIn(slabs)) {
            return slabs;
        }
        Departure departure = start.surface() == number ? start.side() : start.sideSeenFrom(number);
        for (int axis = 0; axis < AXES; axis++) {
            if (slabs[axis].startsOnFace()) {
                slabs[axis] = departure == Departure.INWARD ? slabs[axis].withSides(-1, 1)
                    : seen(slabs[axis], slab(start.seenFrom(), start.seenFromError(), direction, axis), departure);
            }
        }
        return slabs;
    }

    /** With the start on that side of each face that it is on from which it was seen; or, if that is on it too,
        to which it was left. */
    private static Slab seen(Slab slab, Slab from, Departure departure) {
        int near = from.sideOfNear();
        int far = from.sideOfFar();
        return departure == Departure.OUTWARD ? slab.withSides(near == 0 ? 1 : near, far == 0 ? -1 : far)
            : slab.withSides(near, far);
    }

    /** The same for a start of which only the place is known. */
    private Slab[] slabs(Vector start, double error, DyadicVector direction) {
        return new Slab[] {slab(start, error, direction, 0), slab(start, error, direction, 1),
            slab(start, error, direction, 2)};
    }

    private Slab slab(Vector start, double error, DyadicVector direction, int axis) {
        return switch (axis) {
            case 0 -> slab(centre.x().minus(Dyadic.of(start.x())), Dyadic.of(error), direction.x());
            case 1 -> slab(centre.y().minus(Dyadic.of(start.y())), Dyadic.of(error), direction.y());
            default -> slab(centre.z().minus(Dyadic.of(start.z())), Dyadic.of(error), direction.z());
        };
    }

    private Slab slab(Dyadic toMiddle, Dyadic error, Dyadic direction) {
        Dyadic ahead = direction.signum() < 0 ? toMiddle.negated() : toMiddle;
        Dyadic near = beyond(ahead.minus(half), error);
        Dyadic far = beyond(ahead.plus(half), error);
        return new Slab(direction.abs(), near, near.signum(), far, far.signum());
    }

    /** A way, or 0 if it is within an error. */
    private static Dyadic beyond(Dyadic way, Dyadic error) {
        return way.abs().compareTo(error) <= 0 ? Dyadic.ZERO : way;
    }

    private static boolean startsIn(Slab... slabs) {
        return slabs[0].startsIn() && slabs[1].startsIn() && slabs[2].startsIn();
    }

    /** The axis whose near face is passed last of all, of equal ones the first. */
    private static int entered(Slab... slabs) {
        int entered = NONE;
        for (int axis = 0; axis < AXES; axis++) {
            if (slabs[axis].isCrossed() && (entered == NONE || slabs[axis].isEnteredAfterEntering(slabs[entered]))) {
                entered = axis;
            }
        }
        return entered;
    }

    /** The axis whose far face is passed first of all, of equal ones the first. */
    private static int left(Slab... slabs) {
        int left = NONE;
        for (int axis = 0; axis < AXES; axis++) {
            if (slabs[axis].isCrossed() && (left == NONE || slabs[left].isLeftAfterLeaving(slabs[axis]))) {
                left = axis;
            }
        }
        return left;
    }
}
