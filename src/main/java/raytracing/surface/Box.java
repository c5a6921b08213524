package raytracing.surface;

import java.util.Optional;
import raytracing.hierarchy.Bounds;
import raytracing.math.CompensatedSum;
import raytracing.math.Slabs;
import raytracing.math.Surd;
import raytracing.math.Vector;

/**
 * The scene line {@code box}: a cube along the axes, with its boundary.
 *
 * <p>Crossings come from slabs: a ray is inside the cube while it is between all three pairs of faces (Kay, Kajiya, Ray
 * Tracing Complex Scenes, SIGGRAPH 1986, section 4). With h half the edge, the faces lie at the real numbers centre - h and
 * centre + h, which need not be doubles: a box stored as two rounded corners would be another box. Doubles decide where the
 * times at which the ray passes the faces are further apart than their errors; what they leave open is undecided, and
 * {@link ExactBox} decides. Then the way to the one face that counts is summed with a single rounding and divided by the
 * direction. No decision is wrong, whatever finite numbers come, so no ray slips between two boxes that share a face (proved
 * below, measured in {@code NumericsRowsTest}); a crossing's error is at most 2 ulp (proved: a rounding for the sum and one
 * for the quotient).
 *
 * @param centre its middle, world axes
 * @param edge length of an edge, above 0, finite
 * @param material number of its material, from 0
 */
public record Box(Vector centre, double edge, int material) implements Body {
    /**
     * 8 u, with u = 2^-53. A time at which a ray passes a face's plane is (m -+ h) / |d|, with m the way to the
     * middle. Its error is at most 4 u times |m| + h over |d| (proved: a rounding each for m, the sum, the reciprocal
     * and the product), and |m| + h is at most the time itself plus twice h / |d|.
     */
    private static final double ERROR = 0x1p-50;

    /**
     * Squares of directions lie in this range, and times that are told apart below {@link #LARGE}. Where sums of
     * lengths leave the range of doubles, or the reciprocal of a tiny part does, true times are above 2^600; so they
     * are rightly infinite.
     */
    private static final double LEAST_DIRECTION = 0x1p-400;
    private static final double MOST_DIRECTION = 0x1p400;
    private static final double LARGE = 0x1p500;

    /**
     * The square of how much smaller than the whole direction a part may be to count as one along which the ray goes.
     * Of a smaller one, times are larger than all others where its way to a face is above the margin, and of the same
     * sign.
     */
    private static final double SMALLEST_PART = 0x1p400;

    /** Times this far apart are so despite all that is lost below the normal numbers. */
    private static final double SMALL = 0x1p-600;

    /** Of a longer way to a face, the time is above 2^600 if the part of the direction has no reciprocal. */
    private static final double SHORTEST_WAY = 0x1p-350;

    /** Longer by more than the errors of a time, which are 5 u of it. */
    private static final double LENGTHENED = 1 + 0x1p-48;

    /** Far above the 2 ulp of a distance along an axis. */
    private static final double ROUNDING = 0x1p-48;

    private static final int X = 0;
    private static final int Y = 1;
    private static final int Z = 2;

    @Override
    public double firstCrossing(Ray ray, double latest) {
        RayOrigin o = ray.origin;
        return isPlainlyMissed(centre.x(), centre.y(), centre.z(), edge, o.x, o.y, o.z,
            ray.dx, ray.dy, ray.dz, latest, o.error) ? MISS : firstCrossing(ray);
    }

    /**
     * Whether a line plainly passes a cube: the times at which it passes the faces differ by more than their errors. Takes
     * plain numbers, which loops over many boxes keep in registers.
     *
     * @param packed of the cube, from {@code at} on
     * @param latest the last t that matters, above 0
     * @param error how far each coordinate of the points at t = 0 and at {@code latest} may be off
     * @return true only if o + t d is outside the cube for all t from 0 to {@code latest}, both included
     */
    public static boolean isPlainlyMissed(double[] packed, int at, double ox, double oy, double oz,
                                          double dx, double dy, double dz, double latest, double error) {
        return isPlainlyMissed(packed[at], packed[at + 1], packed[at + 2], packed[at + 3], ox, oy, oz, dx, dy, dz,
            latest, error);
    }

    /** The same, given the middle and the edge of a cube. */
    private static boolean isPlainlyMissed(double x, double y, double z, double edge, double ox, double oy, double oz,
                                           double dx, double dy, double dz, double latest, double error) {
        double h = edge / 2;
        double mx = Slabs.ahead(ox, dx, x);
        double my = Slabs.ahead(oy, dy, y);
        double mz = Slabs.ahead(oz, dz, z);
        double grown = h + margin(h, error);
        double ix = 1 / Math.abs(dx);
        double iy = 1 / Math.abs(dy);
        double iz = 1 / Math.abs(dz);
        double entry = Slabs.entry(mx, my, mz, grown, ix, iy, iz);
        double exit = Slabs.exit(mx, my, mz, grown, ix, iy, iz);
        boolean isMissed = exit < -SMALL || entry > exit * LENGTHENED + SMALL && exit < LARGE
            || entry > latest * LENGTHENED + SMALL && latest < LARGE;
        return isMissed && isOrdinary(square(dx, dy, dz));
    }

    /** The crossing by plain doubles, if the ray comes from outside and not at an edge; else undecided, also for a miss. */
    private double firstCrossing(Ray ray) {
        // Ways to the middle, counted along the ray: to the near face it is h less, to the far face h more.
        RayOrigin o = ray.origin;
        double h = edge / 2;
        double mx = Slabs.ahead(o.x, ray.dx, centre.x());
        double my = Slabs.ahead(o.y, ray.dy, centre.y());
        double mz = Slabs.ahead(o.z, ray.dz, centre.z());
        double grown = h + margin(h, o.error);
        double ix = 1 / Math.abs(ray.dx);
        double iy = 1 / Math.abs(ray.dy);
        double iz = 1 / Math.abs(ray.dz);
        double enterX = (mx - grown) * ix;
        double enterY = (my - grown) * iy;
        double enterZ = (mz - grown) * iz;
        double entry = greatest(enterX, enterY, enterZ);
        double exit = Slabs.exit(mx, my, mz, grown, ix, iy, iz);
        double slack = slack(exit, h, o.error, greatest(ix, iy, iz));
        if (entry > slack && entry < exit - slack && exit < LARGE && isOrdinary(square(ray.dx, ray.dy, ray.dz))) {
            // Certainly met from outside: at the face that is passed last, if that is beyond doubt.
            double before = entry - slack;
            int last = (enterX < before ? 0 : 1 << X) | (enterY < before ? 0 : 1 << Y) | (enterZ < before ? 0 : 1 << Z);
            if (Integer.bitCount(last) == 1) {
                return nearFaceCrossing(ray, Integer.numberOfTrailingZeros(last));
            }
        }
        return firstCrossingOfOther(ray);
    }

    private double nearFaceCrossing(Ray ray, int axis) {
        RayOrigin o = ray.origin;
        return switch (axis) {
            case X -> entry(o.x, ray.dx, centre.x());
            case Y -> entry(o.y, ray.dy, centre.y());
            default -> entry(o.z, ray.dz, centre.z());
        };
    }

    /**
     * For a cube around the ray's origin, and for rays along an axis or a face. Of the latest entry or the first exit,
     * the error is no larger than that of all three.
     */
    private double firstCrossingOfOther(Ray ray) {
        RayOrigin o = ray.origin;
        double h = edge / 2;
        double mx = Slabs.ahead(o.x, ray.dx, centre.x());
        double my = Slabs.ahead(o.y, ray.dy, centre.y());
        double mz = Slabs.ahead(o.z, ray.dz, centre.z());
        double square = square(ray.dx, ray.dy, ray.dz);
        double inner = h - margin(h, o.error);
        double ix = 1 / Math.abs(ray.dx);
        double iy = 1 / Math.abs(ray.dy);
        double iz = 1 / Math.abs(ray.dz);
        double entry = Slabs.entry(mx, my, mz, inner, ix, iy, iz);
        double exit = Slabs.exit(mx, my, mz, inner, ix, iy, iz);
        double slack = slack(exit, h, o.error, largest(ix, iy, iz, square));
        if (exit < LARGE && isOrdinary(square)) {
            if (entry > slack && entry < exit - slack) {
                return greatest(entry(o.x, ray.dx, centre.x()), entry(o.y, ray.dy, centre.y()),
                    entry(o.z, ray.dz, centre.z()));
            }
            if (entry < -slack && exit > slack) {
                return firstExit(ray);
            }
        }
        return UNDECIDED;
    }

    private double firstExit(Ray ray) {
        RayOrigin o = ray.origin;
        return least(exit(o.x, ray.dx, centre.x()), exit(o.y, ray.dy, centre.y()), exit(o.z, ray.dz, centre.z()));
    }

    /** Nothing tests whether the rounded origin is inside: it is, by what is known of it. */
    @Override
    public double farWall(Ray ray) {
        RayOrigin o = ray.origin;
        double shortest = least(wayOut(o.x, ray.dx, centre.x()), wayOut(o.y, ray.dy, centre.y()),
            wayOut(o.z, ray.dz, centre.z()));
        double exit = firstExit(ray);
        // within the origin's error of a second wall, doubles cannot tell whether that one is met at once
        boolean isClear = shortest > margin(edge / 2, 2 * o.error) && exit < MISS;
        return isClear && isOrdinary(square(ray.dx, ray.dy, ray.dz)) ? exit : UNDECIDED;
    }

    @Override
    public Optional<Surd> exactCrossing(Ray ray, int number) {
        return ray.leavesOutward(number) ? Optional.empty() : ExactBox.of(this).firstCrossing(ray, number);
    }

    @Override
    public boolean isCrossed(Segment segment, int number) {
        RayOrigin o = segment.start;
        return !isPlainlyMissed(centre.x(), centre.y(), centre.z(), edge, o.x, o.y, o.z,
                segment.dx, segment.dy, segment.dz, 1, segment.error)
            && isCrossedClosely(segment, number);
    }

    /** The same as {@link #isCrossed(Segment, int)} for a cube that is not plainly missed. */
    public boolean isCrossedClosely(Segment segment, int number) {
        Answer quick = isCrossed(segment);
        return quick == Answer.UNDECIDED ? isCrossedExactly(segment, number) : quick == Answer.YES;
    }

    /** By doubles alone; the answer is the same from either end. Undecided of a segment that passes. */
    private Answer isCrossed(Segment segment) {
        RayOrigin p = segment.start;
        double dx = segment.dx;
        double dy = segment.dy;
        double dz = segment.dz;
        double h = edge / 2;
        double mx = Slabs.ahead(p.x, dx, centre.x());
        double my = Slabs.ahead(p.y, dy, centre.y());
        double mz = Slabs.ahead(p.z, dz, centre.z());
        double square = square(dx, dy, dz);
        double inner = h - margin(h, segment.error);
        double ix = 1 / Math.abs(dx);
        double iy = 1 / Math.abs(dy);
        double iz = 1 / Math.abs(dz);
        double entry = Slabs.entry(mx, my, mz, inner, ix, iy, iz);
        double exit = Slabs.exit(mx, my, mz, inner, ix, iy, iz);
        double slack = slack(exit, h, segment.error, largest(ix, iy, iz, square));
        if (entry < exit - slack && exit < LARGE && isOrdinary(square)) {
            if (entry > slack && entry < 1 - slack) {
                return Answer.YES;           // comes in
            }
            if (entry < -slack && exit > slack && Math.abs(exit - 1) > slack) {
                return Answer.of(exit < 1);  // starts inside: goes out, or not
            }
        }
        return Answer.UNDECIDED;
    }

    private boolean isCrossedExactly(Segment segment, int number) {
        return !staysOut(segment) && !staysIn(segment) && ExactBox.of(this).isCrossed(segment, number);
    }

    /** Whether a segment certainly stays before a face, as to a lamp on it: it starts in front,
        and ends there or on its plane. */
    private boolean staysOut(Segment segment) {
        RayOrigin start = segment.start;
        return staysOut(start.x, start.error, segment.endX, segment.endError, centre.x())
            || staysOut(start.y, start.error, segment.endY, segment.endError, centre.y())
            || staysOut(start.z, start.error, segment.endZ, segment.endError, centre.z());
    }

    private boolean staysOut(double start, double startError, double end, double endError, double middle) {
        double sign = Math.copySign(1, start - middle);
        return outside(start, sign, middle) > (1 + ROUNDING) * startError
            && outside(end, sign, middle) >= -(1 - ROUNDING) * endError;
    }

    /** Whether a segment certainly stays inside, as to a lamp on the inner wall: it starts inside,
        and ends there or on a wall. */
    private boolean staysIn(Segment segment) {
        RayOrigin start = segment.start;
        return staysIn(start.x, start.error, segment.endX, segment.endError, centre.x())
            && staysIn(start.y, start.error, segment.endY, segment.endError, centre.y())
            && staysIn(start.z, start.error, segment.endZ, segment.endError, centre.z());
    }

    private boolean staysIn(double start, double startError, double end, double endError, double middle) {
        return outside(start, middle) < -(1 + ROUNDING) * startError && outside(end, middle) <= (1 - ROUNDING) * endError;
    }

    /** How far a point is outside both faces of an axis, below 0 between them. */
    private double outside(double point, double middle) {
        return Math.max(outside(point, 1, middle), outside(point, -1, middle));
    }

    /**
     * How far a point is outside a face's plane, on the side away from the middle.
     *
     * @param sign 1 for the face at c + h, -1 for that at c - h
     * @return sign (p - c) - h, rounded once
     */
    private double outside(double p, double sign, double c) {
        double h = edge / 2;
        double fromMiddle = sign * (p - c);
        double way = fromMiddle - h;
        return way + (CompensatedSum.errorOfSum(sign * p, -sign * c, fromMiddle)
            + CompensatedSum.errorOfSum(fromMiddle, -h, way));
    }

    @Override
    public boolean isLeft(Segment segment) {
        Answer quick = isOutside(segment.endX, segment.endY, segment.endZ, segment.endError);
        return quick == Answer.UNDECIDED ? ExactBox.of(this).side(segment.end(), segment.endError) > 0
            : quick == Answer.YES;
    }

    /** Whether a point is strictly outside; undecided within its error of a face's plane. */
    private Answer isOutside(double px, double py, double pz, double pointError) {
        double h = edge / 2;
        double furthest = Vector.largestPart(px - centre.x(), py - centre.y(), pz - centre.z());
        double slack = ERROR * (furthest + h) + pointError;
        return Math.abs(furthest - h) > slack ? Answer.of(furthest > h) : Answer.UNDECIDED;
    }

    /**
     * The distance at which a ray passes a face's plane.
     *
     * @param o origin of the ray on the face's axis
     * @param d its direction on that axis, not 0
     * @param c centre of the cube on that axis
     * @param towards -h for the face that the ray passes first, h for the other
     * @return error at most 2 ulp (proved: the way is rounded once, and so is the quotient)
     */
    private static double crossing(double o, double d, double c, double towards) {
        double sign = Math.copySign(1, d);
        double middle = sign * (c - o);
        double way = middle + towards;
        double left = CompensatedSum.errorOfSum(sign * c, -sign * o, middle)
            + CompensatedSum.errorOfSum(middle, towards, way);
        return (way + left) / Math.abs(d);
    }

    /** When a ray passes the near face of an axis. */
    private double entry(double o, double d, double c) {
        return d == 0 ? -MISS : crossing(o, d, c, -edge / 2);
    }

    /** When it passes the far face. */
    private double exit(double o, double d, double c) {
        return d == 0 ? MISS : crossing(o, d, c, edge / 2);
    }

    /** The way to the far face of an axis, rounded. */
    private double wayOut(double o, double d, double c) {
        return d == 0 ? MISS : Slabs.ahead(o, d, c) + edge / 2;
    }

    /** By how much a face may be off, seen from a point beside it: what decides for a ray that runs along it. */
    private static double margin(double h, double error) {
        return 4 * ERROR * h + (error + SHORTEST_WAY);
    }

    /**
     * A bound on the error of entry and exit, sum of the two, where they decide anything: an entry much later than the
     * exit needs no bound. The starting point's own error counts on every axis.
     */
    private static double slack(double exit, double h, double error, double largestReciprocal) {
        return 4 * ERROR * Math.max(exit, 0) + 4 * margin(h, error) * largestReciprocal;
    }

    /** Of the reciprocals of a ray's direction; on an axis along which it does not go, no time is off. */
    private static double largest(double ix, double iy, double iz, double square) {
        return greatest(counted(ix, square), counted(iy, square), counted(iz, square));
    }

    private static double counted(double reciprocal, double square) {
        return reciprocal * reciprocal * square < SMALLEST_PART ? reciprocal : 0;
    }

    private static double square(double dx, double dy, double dz) {
        return dx * dx + dy * dy + dz * dz;
    }

    private static boolean isOrdinary(double square) {
        return square > LEAST_DIRECTION && square < MOST_DIRECTION;
    }

    private static double least(double x, double y, double z) {
        return Math.min(x, Math.min(y, z));
    }

    private static double greatest(double x, double y, double z) {
        return Math.max(x, Math.max(y, z));
    }

    @Override
    public int side(RayOrigin point, int number) {
        return ExactBox.of(this).side(point, number);
    }

    /**
     * How a point lies to the two faces across one axis.
     *
     * @param axis 0 for x, 1 for y, 2 for z
     * @return 1 beyond one of their planes, -1 between them, 0 on one of them and seen from a point of that plane
     */
    public int side(RayOrigin point, int number, int axis) {
        return ExactBox.of(this).side(point, number, axis);
    }

    @Override
    public void pack(double[] numbers, int at) {
        numbers[at] = centre.x();
        numbers[at + 1] = centre.y();
        numbers[at + 2] = centre.z();
        numbers[at + 3] = edge;
    }

    @Override
    public void bound(Bounds bounds, int i) {
        bounds.setAround(i, centre.x(), centre.y(), centre.z(), edge / 2);
    }

    @Override
    public boolean isApartFrom(double x, double y, double z, double radius) {
        double furthest = Vector.largestPart(x - centre.x(), y - centre.y(), z - centre.z());
        return furthest > (1 + ROUNDING) * (edge / 2 + radius);
    }

    @Override
    public double depth(Vector point) {
        return edge / 2 - point.minus(centre).largestPart();
    }

    @Override
    public boolean isInPlaceOf(Surface other) {
        return other instanceof Box box && edge == box.edge && centre.isSameAs(box.centre);
    }

    /**
     * The point is on the face to the last bit, and within its edges. On an edge it is a face through which the ray comes in,
     * if there is one, and the first of x, y, z.
     */
    @Override
    public void describe(Ray ray, int number, double distance, Hit hit) {
        boolean isSeenFromInside = isSeenFromInside(ray, number, distance);
        double towards = isSeenFromInside ? edge / 2 : -edge / 2;
        int faces = facesAt(ray, distance, towards);
        int axis = Integer.numberOfTrailingZeros(Integer.bitCount(faces) == 1 && distance > 0 ? faces
            : ExactBox.of(this).axesCrossed(ray, number));
        describeFace(ray, number, distance, axis, isSeenFromInside ? Departure.INWARD : Departure.OUTWARD, hit);
    }

    /**
     * Computes point and normal of a crossing with one of the faces.
     *
     * @param axis of the face: 0 for x, 1 for y, 2 for z
     * @param side from which the ray comes: outward or inward
     */
    private void describeFace(Ray ray, int number, double distance, int axis, Departure side, Hit hit) {
        RayOrigin o = ray.origin;
        double outwards = side == Departure.INWARD ? 1 : -1;
        double nx = axis == X ? Math.copySign(1, outwards * ray.dx) : 0;
        double ny = axis == Y ? Math.copySign(1, outwards * ray.dy) : 0;
        double nz = axis == Z ? Math.copySign(1, outwards * ray.dz) : 0;
        if (distance == 0) {
            hit.placeAtOrigin(ray);
        } else {
            hit.placeAlong(ray, distance * Vector.largestPart(ray.dx, ray.dy, ray.dz),
                onFace(o.x + distance * ray.dx, centre.x(), nx), onFace(o.y + distance * ray.dy, centre.y(), ny),
                onFace(o.z + distance * ray.dz, centre.z(), nz));
        }
        hit.normal.set(nx, ny, nz);
        hit.reach(ray, number, side);
    }

    private double onFace(double along, double c, double normal) {
        double half = edge / 2;
        return normal == 0 ? Math.max(c - half, Math.min(c + half, along)) : c + normal * half;
    }

    /**
     * Whether a ray that meets the walls does so from inside; one that starts on them meets them on the far side. Where
     * doubles do not tell where the origin lies, the kind of face that is met at this distance does, unless both kinds are.
     */
    private boolean isSeenFromInside(Ray ray, int number, double distance) {
        RayOrigin o = ray.origin;
        if (o.surface == number) {
            return o.side == Departure.INWARD;
        }
        Answer isOutside = isOutside(o.x, o.y, o.z, o.error);
        if (isOutside != Answer.UNDECIDED) {
            return isOutside == Answer.NO;
        }
        boolean isEntered = facesAt(ray, distance, -edge / 2) != 0;
        boolean isLeft = facesAt(ray, distance, edge / 2) != 0;
        return distance > 0 && isEntered != isLeft ? isLeft : side(o, number) <= 0;
    }

    /** The near or the far faces that a ray passes at this distance, a bit 1 << axis for each. */
    private int facesAt(Ray ray, double distance, double towards) {
        RayOrigin o = ray.origin;
        double tolerance = ROUNDING * distance;
        return (off(o.x, ray.dx, centre.x(), towards, distance) <= tolerance ? 1 << X : 0)
            | (off(o.y, ray.dy, centre.y(), towards, distance) <= tolerance ? 1 << Y : 0)
            | (off(o.z, ray.dz, centre.z(), towards, distance) <= tolerance ? 1 << Z : 0);
    }

    /** How far from this distance the ray passes a face's plane: 0 for the face that it meets there. */
    private static double off(double o, double d, double c, double towards, double distance) {
        return d == 0 ? MISS : Math.abs(crossing(o, d, c, towards) - distance);
    }

    /**
     * The faces on which a point of this box lies within its error, through which a ray enters from there, and from before
     * which the point was seen.
     *
     * @return a bit 1 &lt;&lt; axis for each face, with axis 0 for x, 1 for y, 2 for z; 0 if the point is not on this box
     */
    public int facesEntered(RayOrigin point, Ray ray) {
        double dx = ray.dx;
        double dy = ray.dy;
        double dz = ray.dz;
        double x = Slabs.ahead(point.x, dx, centre.x());
        double y = Slabs.ahead(point.y, dy, centre.y());
        double z = Slabs.ahead(point.z, dz, centre.z());
        if (Vector.largestPart(x, y, z) > edge / 2 + point.error) {
            return 0;
        }
        Vector from = point.seenFrom();
        return (isEntered(x, Slabs.ahead(from.x(), dx, centre.x()), point) ? 1 << X : 0)
            | (isEntered(y, Slabs.ahead(from.y(), dy, centre.y()), point) ? 1 << Y : 0)
            | (isEntered(z, Slabs.ahead(from.z(), dz, centre.z()), point) ? 1 << Z : 0);
    }

    /** Whether a point is on the near face, seen from before it. */
    private boolean isEntered(double way, double wayFromAfar, RayOrigin point) {
        return way >= edge / 2 - point.error && wayFromAfar > edge / 2 + point.seenFromError();
    }

    /**
     * Describes a crossing at an edge or corner again, from outside, as one with the first of some faces, unless the hit is on
     * one of these already.
     *
     * @param faces some of those that {@link #facesEntered} gives
     */
    public void describeOnFaces(int faces, Ray ray, int number, double distance, Hit hit) {
        int axis = hit.normalX() != 0 ? X : hit.normalY() != 0 ? Y : Z;
        if ((faces & 1 << axis) == 0) {
            describeFace(ray, number, distance, Integer.numberOfTrailingZeros(faces), Departure.OUTWARD, hit);
        }
    }

    @Override
    public <R> R accept(Visitor<R> visitor) {
        return visitor.visit(this);
    }
}
