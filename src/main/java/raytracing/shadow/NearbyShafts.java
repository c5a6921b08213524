package raytracing.shadow;

import java.util.Arrays;
import raytracing.math.Vector;
import raytracing.surface.Hit;
import raytracing.surface.Plane;

/**
 * All shafts to one light from points of a surface that are close to one another, as those of neighbouring pixels are: which
 * surfaces are beside them all is found once, and these need not be sorted for each point.
 *
 * <p>Together the shafts lie in the convex hull of two balls: one around the points, and one around the light's square, however
 * that turns. At first only a point is noted; the surfaces are looked at when a second one comes, so that points far from each
 * other cost next to nothing. Not thread-safe.
 */
final class NearbyShafts {
    /** Half a diagonal of a square over half its edge, rounded up. */
    private static final double DIAGONAL = 1.4142136;

    private static final int NO_LIGHT = -1;

    /** Radius of the ball around the points, as a share of the way to the light (tuned by measurement: DECISIONS). */
    private static final double SPREAD = 0x1p-4;

    final Entries planes = new Entries();
    final Entries spheres = new Entries();
    final Entries boxes = new Entries();
    final Entries triangles = new Entries();
    private int light = NO_LIGHT;
    private int surface;
    private double pointError;
    private boolean isKnown;

    /** The ball around the points; no point is in it if its squared radius is below 0. */
    private double x;
    private double y;
    private double z;
    private double squaredSpread;

    /** The middle of the light, and half the diagonal of its square. */
    private double lightX;
    private double lightY;
    private double lightZ;
    private double halfDiagonal;

    /** The way from the middle of the points to the light, and the unit vector along it. */
    private double depth;
    private double wx;
    private double wy;
    private double wz;

    /** The radii of the two balls, with the errors of their points; and how the hull widens from one to the other. */
    private double pointRadius;
    private double lightRadius;
    private double slope;
    private double cosine;

    /** Above the margin of each of the shafts: how far surfaces may be off. */
    private double margin;

    /** Forgets all points. */
    void clear() {
        light = NO_LIGHT;
    }

    /** Whether a hit is close to the one that was noted, on the same surface. */
    boolean holds(int lightNumber, Hit hit) {
        if (lightNumber != light || hit.surface() != surface || hit.error() > pointError) {
            return false;
        }
        double dx = hit.x() - x;
        double dy = hit.y() - y;
        double dz = hit.z() - z;
        return dx * dx + dy * dy + dz * dz <= squaredSpread;
    }

    /** Notes a hit. Arguments are those of {@link Shaft#aim}. */
    void begin(int lightNumber, Hit hit, double middleX, double middleY, double middleZ, double error, double width) {
        light = lightNumber;
        surface = hit.surface();
        pointError = 2 * hit.error();
        isKnown = false;
        x = hit.x();
        y = hit.y();
        z = hit.z();
        lightX = middleX;
        lightY = middleY;
        lightZ = middleZ;
        depth = Vector.length(lightX - x, lightY - y, lightZ - z);
        halfDiagonal = DIAGONAL * width / 2;
        double size = depth + width + Vector.largestPart(x, y, z) + Vector.largestPart(lightX, lightY, lightZ);
        margin = 16 * (pointError + error) + 4 * Shaft.ROUNDING * size;
        lightRadius = halfDiagonal + margin;
        boolean isUseful = lightRadius < depth / 2 && margin < halfDiagonal && size < Double.MAX_VALUE / 4;
        squaredSpread = isUseful ? SPREAD * depth * (SPREAD * depth) : -1;
    }

    /**
     * Whether the surfaces that are not certainly beside all shafts are known. If not, they are to be asked for by
     * {@link #isBeside} and added to {@link #planes}, {@link #spheres}, {@link #boxes} and {@link #triangles} now.
     */
    boolean areKnown() {
        if (isKnown) {
            return true;
        }
        isKnown = true;
        planes.clear();
        spheres.clear();
        boxes.clear();
        triangles.clear();
        wx = (lightX - x) / depth;
        wy = (lightY - y) / depth;
        wz = (lightZ - z) / depth;
        pointRadius = SPREAD * depth + margin;
        slope = (lightRadius - pointRadius) / depth;
        cosine = Math.sqrt(1 - slope * slope);
        return false;
    }

    /** Whether all surfaces but that of the points are beside all shafts. */
    boolean areClear() {
        return planes.count + spheres.count + boxes.count + triangles.count == 0;
    }

    /** Whether the whole square is certainly above the horizon of a hit. */
    boolean isWhollySeen(Hit hit) {
        return hit.alongNormal(lightX - hit.x(), lightY - hit.y(), lightZ - hit.z()) > halfDiagonal + 2 * margin;
    }

    /**
     * Whether a ball is outside the hull. The hull's mantle touches both balls, and so is a cone; a point that is h away from
     * its axis and t along it is outside if h cosine exceeds the radius at t, pointRadius + slope t.
     */
    boolean isBeside(double cx, double cy, double cz, double radius) {
        double fx = cx - x;
        double fy = cy - y;
        double fz = cz - z;
        double grown = radius + margin + Shaft.ROUNDING * (Math.abs(fx) + Math.abs(fy) + Math.abs(fz) + radius);
        double along = fx * wx + fy * wy + fz * wz;
        double aside = Vector.length(fy * wz - fz * wy, fz * wx - fx * wz, fx * wy - fy * wx);
        return aside * cosine - pointRadius - slope * along > grown
            || along + grown < -pointRadius || along - grown > depth + lightRadius;
    }

    /** Whether both balls are on the same side of a plane. */
    boolean isBeside(Plane plane) {
        double nx = plane.normal().x();
        double ny = plane.normal().y();
        double nz = plane.normal().z();
        double gap = plane.offset() - (nx * x + ny * y + nz * z);
        double lightGap = plane.offset() - (nx * lightX + ny * lightY + nz * lightZ);
        double length = plane.normal().length() * (1 + Shaft.ROUNDING);
        double error = Shaft.ROUNDING * (Math.abs(plane.offset()) + Math.abs(gap) + Math.abs(lightGap)) + length * margin;
        return gap > 0 == lightGap > 0 && Math.abs(gap) > length * pointRadius + error
            && Math.abs(lightGap) > length * lightRadius + error;
    }

    /** Places in a list of surfaces. */
    static final class Entries {
        private int[] places = new int[4];
        private int count;

        void clear() {
            count = 0;
        }

        void add(int place) {
            if (count == places.length) {
                places = Arrays.copyOf(places, 2 * count);
            }
            places[count++] = place;
        }

        int count() {
            return count;
        }

        int place(int i) {
            return places[i];
        }
    }
}
