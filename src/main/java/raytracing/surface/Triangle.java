package raytracing.surface;

import java.util.Optional;
import raytracing.hierarchy.Bounds;
import raytracing.math.CompensatedSum;
import raytracing.math.Determinant;
import raytracing.math.Surd;
import raytracing.math.Vector;

/**
 * The scene line {@code trg}: the points between three corners, border included, with two sides and no inside. Kept as
 * numbers and not as vectors, as files have millions of triangles.
 *
 * <p>Let A, B and C be the ways from a ray's origin to the corners and d its direction. The ray's line meets the triangle if
 * the volumes d . (A x B), d . (B x C) and d . (C x A) have no two opposite signs: on which side of each edge it passes. A
 * triangle on the other side of an edge finds the same volume with the other sign, so no line passes between the two. The sum
 * of the volumes is the approach N . d, with the normal N = (b - a) x (c - a); the gap is N . A; the ray meets the plane at
 * gap over approach (Moeller, Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, J. Graphics Tools 2:1, 1997; in this
 * form Woop, Benthin, Wald, Watertight Ray/Triangle Intersection, J. Computer Graphics Techniques 2:1, 2013, who still lose
 * what rounding takes).
 *
 * <p>A bound on the errors, known beforehand, tells whether doubles decide; what they leave open, {@link ExactTriangle}
 * decides. So no decision is wrong, whatever finite numbers come. A crossing is the quotient of two compensated sums; its
 * error is at most 4 u (proved below). In these proofs u = 2^-53, m is the largest coordinate of A, B and C, and s the sum of
 * the sizes of the coordinates of d.
 *
 * @param material number of its material, from 0
 */
public record Triangle(double ax, double ay, double az, double bx, double by, double bz, double cx, double cy, double cz,
                       int material) implements Bounded {
    /** The edges, as {@link #touchedEdges} adds them up. */
    public static final int AB = 1;
    public static final int BC = 2;
    public static final int CA = 4;

    /** "The point does not touch the triangle", for {@link #touchedEdges}. */
    public static final int NOT_TOUCHED = -1;

    /**
     * 32 u: the error of a volume is at most 16 u s m m and smaller terms (proved: 8 u m m for each part of a cross product of
     * rounded ways, then 4 u for a rounded direction and its products, 4 u for two sums).
     */
    private static final double VOLUME_ERROR = 0x1p-48;

    /** By how much a volume changes, in multiples of s m, if the origin moves by four times its error: 4 times 4. */
    private static final double MOVED = 16;

    /** The same of a gap, in multiples of m m: 4 times 24. */
    private static final double MOVED_GAP = 96;

    /** Products between these carry no trace of subnormal numbers or of overflow. */
    private static final double SMALL = 0x1p-900;
    private static final double LARGE = 0x1p900;

    /** Of the product of its vectors' sizes, how large a determinant must be to be off by less than u (1 + 2^-3). */
    private static final double CLEAR = 0x1p-42;

    /** How a line passes the triangle: beside it, or through it in the direction of the normal or against that. */
    private static final int BESIDE = 0;
    private static final int ALONG = 1;
    private static final int AGAINST = -1;
    private static final int UNKNOWN = 2;

    /** A crossing below this may carry the trace of a subnormal number. */
    private static final double SMALLEST = Double.MIN_NORMAL;

    /** The triangle between three corners that are not on one line. */
    public static Triangle of(Vector a, Vector b, Vector c, int material) {
        return new Triangle(a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), c.x(), c.y(), c.z(), material);
    }

    /** Whether three points are on one line, so that there is no triangle between them; decided exactly. */
    public static boolean areOnALine(Vector a, Vector b, Vector c) {
        Vector toB = b.minus(a);
        Vector toC = c.minus(a);
        double clear = VOLUME_ERROR * toB.largestPart() * toC.largestPart();
        boolean isClear = isInRange(clear) && toB.cross(toC).largestPart() > clear;
        return !isClear && ExactTriangle.areOnALine(a, b, c);
    }

    public Vector a() {
        return new Vector(ax, ay, az);
    }

    public Vector b() {
        return new Vector(bx, by, bz);
    }

    public Vector c() {
        return new Vector(cx, cy, cz);
    }

    /** A coordinate of a corner, from 0 to 2. */
    public double x(int corner) {
        return corner == 0 ? ax : corner == 1 ? bx : cx;
    }

    public double y(int corner) {
        return corner == 0 ? ay : corner == 1 ? by : cy;
    }

    public double z(int corner) {
        return corner == 0 ? az : corner == 1 ? bz : cz;
    }

    /** The middle of the box around it. */
    public double middleX() {
        return middle(ax, bx, cx);
    }

    public double middleY() {
        return middle(ay, by, cy);
    }

    public double middleZ() {
        return middle(az, bz, cz);
    }

    /** The radius of a ball around that box's middle that holds it, rounded up. */
    public double radius() {
        return (1 + VOLUME_ERROR) * (Vector.length(spread(ax, bx, cx), spread(ay, by, cy), spread(az, bz, cz)) / 2)
            + VOLUME_ERROR * largestPart();
    }

    private static double middle(double a, double b, double c) {
        return Math.max(a, Math.max(b, c)) / 2 + Math.min(a, Math.min(b, c)) / 2;
    }

    /** The radius of the largest disc in it, rounded. */
    public double inradius() {
        double ab = Vector.length(bx - ax, by - ay, bz - az);
        double bc = Vector.length(cx - bx, cy - by, cz - bz);
        double ca = Vector.length(ax - cx, ay - cy, az - cz);
        double half = (ab + bc + ca) / 2;
        return Math.sqrt(Math.max(0, (half - ab) / half * (half - bc) * (half - ca)));
    }

    /** The size of the coordinate furthest from 0, of all corners. */
    public double largestPart() {
        return largest(ax, ay, az, bx, by, bz, cx, cy, cz);
    }

    /** The largest edge of the box around it, along the axes. */
    public double extent() {
        return Math.max(spread(ax, bx, cx), Math.max(spread(ay, by, cy), spread(az, bz, cz)));
    }

    private static double spread(double a, double b, double c) {
        return Math.max(a, Math.max(b, c)) - Math.min(a, Math.min(b, c));
    }

    /**
     * How a line certainly passes the triangle. Most lines pass beside most triangles, so this is as short as it can be: with
     * d x A, two volumes need one cross product, and in place of the largest coordinate the bound has the sum of all, which is
     * larger and sooner found.
     *
     * @param dx direction, of any length; that of a segment is rounded
     * @return {@link #BESIDE}, {@link #ALONG} or {@link #AGAINST}; {@link #UNKNOWN} if doubles cannot tell, or the origin's
     *         error leaves it open
     */
    private int passing(RayOrigin o, double dx, double dy, double dz) {
        double toAx = ax - o.x;
        double toAy = ay - o.y;
        double toAz = az - o.z;
        double toBx = bx - o.x;
        double toBy = by - o.y;
        double toBz = bz - o.z;
        double toCx = cx - o.x;
        double toCy = cy - o.y;
        double toCz = cz - o.z;
        double acrossX = dy * toAz - dz * toAy;
        double acrossY = dz * toAx - dx * toAz;
        double acrossZ = dx * toAy - dy * toAx;
        double ab = toBx * acrossX + toBy * acrossY + toBz * acrossZ;
        double ca = -(toCx * acrossX + toCy * acrossY + toCz * acrossZ);
        double bc = Determinant.rounded(dx, dy, dz, toBx, toBy, toBz, toCx, toCy, toCz);
        double sum = sumOfSizes(toAx, toAy, toAz) + sumOfSizes(toBx, toBy, toBz) + sumOfSizes(toCx, toCy, toCz);
        double error = (VOLUME_ERROR * sum + MOVED * o.error) * (sum * sumOfSizes(dx, dy, dz));
        double least = Math.min(ab, Math.min(bc, ca));
        double most = Math.max(ab, Math.max(bc, ca));
        if (!(isInRange(error) && isInRange(sum * sum))) {
            return UNKNOWN;
        }
        if (least < -error && most > error) {
            return BESIDE;
        }
        return least > error ? ALONG : most < -error ? AGAINST : UNKNOWN;
    }

    private static double sumOfSizes(double x, double y, double z) {
        return Math.abs(x) + Math.abs(y) + Math.abs(z);
    }

    /** On which side of the plane a point certainly is: 1 where the normal points; 0 if doubles or its error leave it open. */
    private int clearSide(double x, double y, double z, double error) {
        double toAx = ax - x;
        double toAy = ay - y;
        double toAz = az - z;
        double toBx = bx - x;
        double toBy = by - y;
        double toBz = bz - z;
        double toCx = cx - x;
        double toCy = cy - y;
        double toCz = cz - z;
        double gap = Determinant.rounded(toAx, toAy, toAz, toBx, toBy, toBz, toCx, toCy, toCz);
        double m = largest(toAx, toAy, toAz, toBx, toBy, toBz, toCx, toCy, toCz);
        double gapError = (3 * VOLUME_ERROR * m + MOVED_GAP * error) * m * m;
        return !(isInRange(gapError) && Math.abs(gap) > gapError) ? 0 : gap < 0 ? 1 : -1;
    }

    /** All crossings are reported, also those beyond {@code latest}: most lines that come here cross in front of it. */
    @Override
    public double firstCrossing(Ray ray, double latest) {
        int passing = passing(ray.origin, ray.dx, ray.dy, ray.dz);
        return passing == BESIDE ? MISS : passing == UNKNOWN ? UNDECIDED : crossingAhead(ray, passing);
    }

    /** The crossing of a ray whose line goes through the triangle along the normal or against it, if the ray heads there. */
    private double crossingAhead(Ray ray, int passing) {
        RayOrigin o = ray.origin;
        int side = clearSide(o.x, o.y, o.z, o.error);
        return side == 0 ? UNDECIDED : side == passing ? MISS : compensatedCrossing(ray);
    }

    private static boolean isInRange(double size) {
        return size > SMALL && size < LARGE;
    }

    /** The quotient of gap and approach, for a ray that certainly meets the triangle. */
    private double compensatedCrossing(Ray ray) {
        RayOrigin o = ray.origin;
        double toX = ax - o.x;
        double toY = ay - o.y;
        double toZ = az - o.z;
        double gap = alongNormal(toX, toY, toZ, CompensatedSum.errorOfSum(ax, -o.x, toX),
            CompensatedSum.errorOfSum(ay, -o.y, toY), CompensatedSum.errorOfSum(az, -o.z, toZ));
        double approach = alongNormal(ray.dx, ray.dy, ray.dz, 0, 0, 0);
        double clear = clearNormal();
        double leastGap = clear * Vector.largestPart(toX, toY, toZ);
        double leastApproach = clear * Vector.largestPart(ray.dx, ray.dy, ray.dz);
        double t = gap / approach;
        boolean isClear = isInRange(clear) && isInRange(leastGap) && Math.abs(gap) > leastGap
            && isInRange(leastApproach) && Math.abs(approach) > leastApproach;
        return isClear && t > SMALLEST && t < MISS ? t : UNDECIDED;
    }

    /** The dot product of the normal with a vector, each coordinate of which is a double and a far smaller one. */
    private double alongNormal(double x, double y, double z, double lowX, double lowY, double lowZ) {
        double ux = bx - ax;
        double uy = by - ay;
        double uz = bz - az;
        double vx = cx - ax;
        double vy = cy - ay;
        double vz = cz - az;
        return Determinant.of(x, y, z, lowX, lowY, lowZ,
            ux, uy, uz, CompensatedSum.errorOfSum(bx, -ax, ux), CompensatedSum.errorOfSum(by, -ay, uy),
            CompensatedSum.errorOfSum(bz, -az, uz),
            vx, vy, vz, CompensatedSum.errorOfSum(cx, -ax, vx), CompensatedSum.errorOfSum(cy, -ay, vy),
            CompensatedSum.errorOfSum(cz, -az, vz));
    }

    /** How large such a product must be beside the vector's largest coordinate to be off by little more than a rounding. */
    private double clearNormal() {
        return CLEAR * Vector.largestPart(bx - ax, by - ay, bz - az) * Vector.largestPart(cx - ax, cy - ay, cz - az);
    }

    @Override
    public Optional<Surd> exactCrossing(Ray ray, int number) {
        return ray.origin.surface == number ? Optional.empty() : ExactTriangle.of(this).firstCrossing(ray, number);
    }

    @Override
    public boolean isCrossed(Segment segment, int number) {
        int passing = passing(segment.start, segment.dx, segment.dy, segment.dz);
        return passing != BESIDE && isCrossed(segment, number, passing);
    }

    private boolean isCrossed(Segment segment, int number, int passing) {
        RayOrigin o = segment.start;
        int side = clearSide(o.x, o.y, o.z, o.error);
        int endSide = clearSide(segment.endX, segment.endY, segment.endZ, segment.endError);
        return passing == UNKNOWN || side == 0 || endSide == 0 ? ExactTriangle.of(this).isCrossed(segment, number)
            : side != endSide;
    }

    /** Whether it ends on the other side of the plane than that from which the hit was seen. */
    @Override
    public boolean isCrossedFrom(Hit hit, Segment segment) {
        int seenFrom = hit.side() == Departure.OUTWARD ? 1 : -1;
        return endSide(segment) == -seenFrom;
    }

    /** On which side of the plane a segment ends: 1 where the normal points; 0 on the triangle within the end's error. */
    private int endSide(Segment segment) {
        int side = clearSide(segment.endX, segment.endY, segment.endZ, segment.endError);
        return side != 0 ? side : ExactTriangle.of(this).endSide(segment);
    }

    private static double largest(double ax, double ay, double az, double bx, double by, double bz,
                                  double cx, double cy, double cz) {
        return Math.max(Vector.largestPart(ax, ay, az),
            Math.max(Vector.largestPart(bx, by, bz), Vector.largestPart(cx, cy, cz)));
    }

    @Override
    public int side(RayOrigin point, int number) {
        return ExactTriangle.of(this).side(point, number);
    }

    /**
     * The edges on which a point lies that touches this triangle.
     *
     * @return {@link #AB}, {@link #BC} and {@link #CA}, added up; or {@link #NOT_TOUCHED}
     */
    public int touchedEdges(RayOrigin point) {
        return ExactTriangle.of(this).touchedEdges(point);
    }

    @Override
    public boolean isInPlaceOf(Surface other) {
        return other instanceof Triangle triangle && triangle.hasCorner(a()) && triangle.hasCorner(b())
            && triangle.hasCorner(c());
    }

    private boolean hasCorner(Vector point) {
        return point.isSameAs(a()) || point.isSameAs(b()) || point.isSameAs(c());
    }

    /** Along the normal, the point is moved onto the plane if a corner is near enough to tell where that is. */
    @Override
    public void describe(Ray ray, int number, double distance, Hit hit) {
        setNormal(hit);
        double nx = hit.normal.x();
        double ny = hit.normal.y();
        double nz = hit.normal.z();
        if (distance > 0) {
            double x = ray.origin.x + distance * ray.dx;
            double y = ray.origin.y + distance * ray.dy;
            double z = ray.origin.z + distance * ray.dz;
            double way = distance * Vector.largestPart(ray.dx, ray.dy, ray.dz);
            double toX = ax - x;
            double toY = ay - y;
            double toZ = az - z;
            double drop = Vector.largestPart(toX, toY, toZ) < way ? nx * toX + ny * toY + nz * toZ : 0;
            hit.placeAlong(ray, way, x + drop * nx, y + drop * ny, z + drop * nz);
        } else {
            hit.placeAtOrigin(ray);
        }
        double along = hit.normal.dot(ray.dx, ray.dy, ray.dz);
        boolean isSeenFromBelow = distance > 0 && Hit.isClear(along, ray) ? along > 0 : side(ray.origin, number) < 0;
        hit.reach(ray, number, isSeenFromBelow ? Departure.INWARD : Departure.OUTWARD);
    }

    /** Each part of the normal is rounded once; of a triangle that is a million million times as long as wide, exactly. */
    private void setNormal(Hit hit) {
        double nx = alongNormal(1, 0, 0, 0, 0, 0);
        double ny = alongNormal(0, 1, 0, 0, 0, 0);
        double nz = alongNormal(0, 0, 1, 0, 0, 0);
        double clear = clearNormal();
        if (isInRange(clear) && Vector.largestPart(nx, ny, nz) > clear) {
            hit.normal.set(nx, ny, nz);
        } else {
            Vector exact = ExactTriangle.of(this).direction();
            hit.normal.set(exact.x(), exact.y(), exact.z());
        }
    }

    @Override
    public void bound(Bounds bounds, int i) {
        bounds.setAround(i, ax, ay, az, bx, by, bz, cx, cy, cz);
    }

    @Override
    public <R> R accept(Visitor<R> visitor) {
        return visitor.visit(this);
    }
}
