package raytracing.geometry;

import java.util.Optional;
import raytracing.math.Surd;
import raytracing.math.Vector;

/**
 * The scene line {@code box}: a cube along the axes, with its boundary.
 *
 * @param centre its middle, world axes
 * @param edge length of an edge, above 0, finite
 * @param material number of its material, from 0
 */
public record Box(Vector centre, double edge, int material) implements Surface {
    /** Far above the 2 ulp of a distance along an axis. */
    private static final double ROUNDING = 0x1p-48;

    private static final int X = 0;
    private static final int Y = 1;
    private static final int Z = 2;

    @Override
    public Optional<Surd> crossing(Standpoint origin, int number, Vector direction) {
        return origin.surface() == number && origin.side() == Departure.OUTWARD ? Optional.empty()
            : ExactBox.of(this).firstCrossing(origin, number, direction);
    }

    @Override
    public boolean isInPlaceOf(Surface other) {
        return other instanceof Box box && edge == box.edge && centre.equals(box.centre);
    }

    @Override
    public boolean isCrossedBetween(Standpoint start, int number, Vector end, double endError) {
        return !staysOut(start, end, endError) && !staysIn(start, end, endError)
            && ExactBox.of(this).isCrossedBetween(start, number, end, endError);
    }

    /** Whether a line certainly stays before a face, as to a lamp on it: it starts in front, and ends there or on its plane. */
    private boolean staysOut(Standpoint start, Vector end, double endError) {
        return staysOut(start.x(), start.error(), end.x(), endError, centre.x())
            || staysOut(start.y(), start.error(), end.y(), endError, centre.y())
            || staysOut(start.z(), start.error(), end.z(), endError, centre.z());
    }

    private boolean staysOut(double start, double startError, double end, double endError, double middle) {
        double sign = Math.copySign(1, start - middle);
        return BoxKernel.outside(start, sign, middle, edge / 2) > (1 + ROUNDING) * startError
            && BoxKernel.outside(end, sign, middle, edge / 2) >= -(1 - ROUNDING) * endError;
    }

    /** Whether a line certainly stays inside, as to a lamp on the inner wall: it starts inside, and ends there or on a wall. */
    private boolean staysIn(Standpoint start, Vector end, double endError) {
        return staysIn(start.x(), start.error(), end.x(), endError, centre.x())
            && staysIn(start.y(), start.error(), end.y(), endError, centre.y())
            && staysIn(start.z(), start.error(), end.z(), endError, centre.z());
    }

    private boolean staysIn(double start, double startError, double end, double endError, double middle) {
        return outside(start, middle) < -(1 + ROUNDING) * startError && outside(end, middle) <= (1 - ROUNDING) * endError;
    }

    /** How far a point is outside both faces of an axis, below 0 between them. */
    private double outside(double point, double middle) {
        return Math.max(BoxKernel.outside(point, 1, middle, edge / 2), BoxKernel.outside(point, -1, middle, edge / 2));
    }

    @Override
    public int side(Standpoint point, int number) {
        return ExactBox.of(this).side(point, number);
    }

    /**
     * How a point lies to the two faces across one axis.
     *
     * @param point the point
     * @param number this surface's number in the scene
     * @param axis 0 for x, 1 for y, 2 for z
     * @return 1 beyond one of their planes, -1 between them, 0 on one of them and seen from a point of that plane
     */
    public int side(Standpoint point, int number, int axis) {
        return ExactBox.of(this).side(point, number, axis);
    }

    @Override
    public double farWall(Standpoint origin, double dx, double dy, double dz) {
        return BoxKernel.acrossFromInnerWall(origin.x(), origin.y(), origin.z(), dx, dy, dz, origin.error(),
            centre.x(), centre.y(), centre.z(), edge / 2);
    }

    @Override
    public boolean isLeftBefore(double qx, double qy, double qz, double endError) {
        Answer quick = BoxKernel.isOutside(qx, qy, qz, endError, centre.x(), centre.y(), centre.z(), edge / 2);
        return quick == Answer.UNDECIDED ? ExactBox.of(this).side(new Vector(qx, qy, qz), endError) > 0
            : quick == Answer.YES;
    }

    @Override
    public boolean isApartFrom(double x, double y, double z, double r) {
        double furthest = Vector.largestPart(x - centre.x(), y - centre.y(), z - centre.z());
        return furthest > (1 + ROUNDING) * (edge / 2 + r);
    }

    /**
     * The point is on the face to the last bit, and within its edges. On an edge it is a face through which the ray comes in,
     * if there is one, and the first of x, y, z.
     */
    @Override
    public void describe(Standpoint origin, int number, double dx, double dy, double dz, double distance,
                         HitPoint found) {
        boolean isSeenFromInside = isSeenFromInside(origin, number, dx, dy, dz, distance);
        double towards = isSeenFromInside ? edge / 2 : -edge / 2;
        int faces = facesAt(origin, dx, dy, dz, distance, towards, ROUNDING * distance);
        int axis = Integer.numberOfTrailingZeros(Integer.bitCount(faces) == 1 && distance > 0 ? faces
            : ExactBox.of(this).axesCrossed(origin, number, new Vector(dx, dy, dz)));
        describe(origin, number, dx, dy, dz, distance, axis, isSeenFromInside ? Departure.INWARD : Departure.OUTWARD, found);
    }

    /**
     * The faces on which a point of this box lies, as far as it is known, through which a line from there goes in, and before
     * which it was seen from.
     *
     * @param point the point
     * @param dx where the line goes, x part
     * @param dy y part
     * @param dz z part
     * @return a bit 1 &lt;&lt; axis for each face, with axis 0 for x, 1 for y, 2 for z; none if the point is not on this box
     */
    public int facesEntered(HitPoint point, double dx, double dy, double dz) {
        double x = wayToMiddle(point.x(), dx, centre.x());
        double y = wayToMiddle(point.y(), dy, centre.y());
        double z = wayToMiddle(point.z(), dz, centre.z());
        if (Vector.largestPart(x, y, z) > edge / 2 + point.error()) {
            return 0;
        }
        Standpoint place = point.place();
        Vector from = place.seenFrom();
        return (isEntered(x, wayToMiddle(from.x(), dx, centre.x()), place) ? 1 << X : 0)
            | (isEntered(y, wayToMiddle(from.y(), dy, centre.y()), place) ? 1 << Y : 0)
            | (isEntered(z, wayToMiddle(from.z(), dz, centre.z()), place) ? 1 << Z : 0);
    }

    /** Whether a point is on the near face, seen from before it. */
    private boolean isEntered(double way, double wayFromAfar, Standpoint point) {
        return way >= edge / 2 - point.error() && wayFromAfar > edge / 2 + point.seenFromError();
    }

    private static double wayToMiddle(double point, double direction, double middle) {
        return Math.copySign(1, direction) * (middle - point);
    }

    private int facesAt(Standpoint origin, double dx, double dy, double dz, double distance, double towards,
                        double tolerance) {
        return (off(origin.x(), dx, centre.x(), towards, distance) <= tolerance ? 1 << X : 0)
            | (off(origin.y(), dy, centre.y(), towards, distance) <= tolerance ? 1 << Y : 0)
            | (off(origin.z(), dz, centre.z(), towards, distance) <= tolerance ? 1 << Z : 0);
    }

    /**
     * Everything about a crossing with one of the faces, as {@link #describe} gives it.
     *
     * @param origin where the ray starts
     * @param number this surface's number in the scene
     * @param dx the ray's direction, x part
     * @param dy y part
     * @param dz z part
     * @param distance the crossing
     * @param axis of the face: 0 for x, 1 for y, 2 for z
     * @param seenFrom the side from which the ray comes: outward or inward
     * @param found takes the point, its error, the normal towards the ray's origin, and how it was reached
     */
    public void describe(Standpoint origin, int number, double dx, double dy, double dz, double distance, int axis,
                         Departure seenFrom, HitPoint found) {
        double outwards = seenFrom == Departure.INWARD ? 1 : -1;
        double nx = axis == X ? Math.copySign(1, outwards * dx) : 0;
        double ny = axis == Y ? Math.copySign(1, outwards * dy) : 0;
        double nz = axis == Z ? Math.copySign(1, outwards * dz) : 0;
        if (distance == 0) {
            found.placeAt(origin);
        } else {
            found.placeAlong(origin, distance * Vector.largestPart(dx, dy, dz),
                onFace(origin.x() + distance * dx, centre.x(), nx), onFace(origin.y() + distance * dy, centre.y(), ny),
                onFace(origin.z() + distance * dz, centre.z(), nz));
        }
        found.reach(nx, ny, nz, seenFrom, number, origin);
    }

    /**
     * Whether a ray that meets the walls does so from inside; one that starts on them meets them on the far side. Where
     * doubles do not tell where the origin lies, the kind of face that is met at this distance does, unless both kinds are.
     */
    private boolean isSeenFromInside(Standpoint origin, int number, double dx, double dy, double dz, double distance) {
        if (origin.surface() == number) {
            return origin.side() == Departure.INWARD;
        }
        Answer isOutside = BoxKernel.isOutside(origin.x(), origin.y(), origin.z(), origin.error(),
            centre.x(), centre.y(), centre.z(), edge / 2);
        if (isOutside != Answer.UNDECIDED) {
            return isOutside == Answer.NO;
        }
        boolean isEntered = facesAt(origin, dx, dy, dz, distance, -edge / 2, ROUNDING * distance) != 0;
        boolean isLeft = facesAt(origin, dx, dy, dz, distance, edge / 2, ROUNDING * distance) != 0;
        return distance > 0 && isEntered != isLeft ? isLeft : side(origin, number) <= 0;
    }

    /** How far from this distance the ray passes a face's plane: 0 for the face that it meets there. */
    private static double off(double o, double d, double c, double towards, double distance) {
        return d == 0 ? MISS : Math.abs(BoxKernel.crossing(o, d, c, towards) - distance);
    }

    private double onFace(double along, double c, double normal) {
        double half = edge / 2;
        return normal == 0 ? Math.max(c - half, Math.min(c + half, along)) : c + normal * half;
    }

    @Override
    public void presentTo(Receiver receiver) {
        receiver.box(this);
    }
}
