package raytracing.shadow;

import raytracing.math.Basis;
import raytracing.math.Vector;
import raytracing.surface.Body;
import raytracing.surface.Hit;
import raytracing.surface.Segment;

/**
 * All lines from a hit to a light's square, which faces it: a pyramid, the shaft (Haines, Wallace, Shaft Culling for Efficient
 * Ray-Cast Radiosity, Eurographics Rendering Workshop 1991). This is its geometry alone.
 *
 * <p>The shaft's coordinates: x and y along the square's axes, z towards its middle, the hit at 0. {@link #aim} alone writes
 * the fields. Not thread-safe.
 */
final class Shaft {
    /**
     * 256 u, with u = 2^-53: the error of the shaft's coordinates of a point, and of tests made of them, in multiples of the
     * sizes that went into them (proved: 8 ulp for the axes, at most 16 roundings in all).
     */
    static final double ROUNDING = 0x1p-45;

    /** Far below the rounding of the largest double: added to any double, it gives a double. */
    private static final double NOTHING_BESIDE_THE_LARGEST = 0x1p900;

    Hit hit = new Hit();

    /** The middle of the light's square, and how far each part of it may be off. */
    double lx;
    double ly;
    double lz;
    double endError;

    /** The way from the hit to the middle of the square. */
    double tx;
    double ty;
    double tz;

    /** The shaft's axes: u and v along the square, w towards it. */
    final Basis axes = new Basis();
    double depth;
    double halfWidth;

    /** How far surfaces may be off, seen from the shaft: the errors of its ends eight times over, and its own rounding. */
    double margin;

    /** Sum of the sizes of all coordinates, which bounds the rounding of products with them. */
    double reach;

    /** From the hit to the middle of an edge of the square, and to a corner. */
    double slant;
    double cornerDistance;

    /** How far the square reaches from its middle along the world's axes. */
    double extentX;
    double extentY;
    double extentZ;

    private final Segment segment = new Segment();
    private double segmentX;
    private double segmentY;

    /**
     * Turns the shaft from a hit to a light.
     *
     * @param from the hit, which must not change while the shaft is used
     * @param lightX middle of the light's square, world axes; not at the hit
     * @param error how far each coordinate of the middle may be off
     * @param width edge of the square; of a square that reaches beyond all doubles, a smaller one with the same middle is
     *        taken
     */
    void aim(Hit from, double lightX, double lightY, double lightZ, double error, double width) {
        hit = from;
        lx = lightX;
        ly = lightY;
        lz = lightZ;
        endError = error;
        double room = (Double.MAX_VALUE - Vector.largestPart(lx, ly, lz)) / 2;   // a corner is at most 1.5 half widths off
        halfWidth = Math.min(width / 2, Math.max(room, NOTHING_BESIDE_THE_LARGEST));
        tx = lx - hit.x();
        ty = ly - hit.y();
        tz = lz - hit.z();
        axes.turnTo(tx, ty, tz);
        depth = tx * axes.wx() + ty * axes.wy() + tz * axes.wz();
        reach = Math.abs(hit.x()) + Math.abs(hit.y()) + Math.abs(hit.z()) + Math.abs(lx) + Math.abs(ly) + Math.abs(lz) + width;
        margin = 8 * (hit.error() + endError) + ROUNDING * (depth + halfWidth);
        slant = Math.sqrt(depth * depth + halfWidth * halfWidth);
        cornerDistance = Math.sqrt(depth * depth + 2 * halfWidth * halfWidth);
        extentX = halfWidth * (Math.abs(axes.ux()) + Math.abs(axes.vx()));
        extentY = halfWidth * (Math.abs(axes.uy()) + Math.abs(axes.vy()));
        extentZ = halfWidth * (Math.abs(axes.uz()) + Math.abs(axes.vz()));
        segmentX = Double.NaN;
    }

    /** Whether rounding moves the light by more than its width, so that only a line to its middle makes sense. */
    boolean isNarrowerThanRounding() {
        return halfWidth < ROUNDING * depth;
    }

    /** How far the walls of a body may be off that is (fx, fy, fz) from the hit and has this radius or half edge. */
    double slack(double fx, double fy, double fz, double half) {
        return margin + ROUNDING * (Math.abs(fx) + Math.abs(fy) + Math.abs(fz) + half);
    }

    /** Whether a body is certainly apart from the light's square. */
    boolean endsApartFrom(Body body) {
        return body.isApartFrom(lx, ly, lz, 2 * halfWidth + margin);
    }

    /** Whether a box of this half edge, margin included, with its centre (fx, fy, fz) from the hit is beside the shaft. */
    boolean isBeside(double fx, double fy, double fz, double half) {
        if (fx - half > Math.max(0, tx + extentX) || fx + half < Math.min(0, tx - extentX)
                || fy - half > Math.max(0, ty + extentY) || fy + half < Math.min(0, ty - extentY)
                || fz - half > Math.max(0, tz + extentZ) || fz + half < Math.min(0, tz - extentZ)) {
            return true;
        }
        double mz = fx * axes.wx() + fy * axes.wy() + fz * axes.wz();
        double halfDepth = half * Math.abs(axes.wx()) + half * Math.abs(axes.wy()) + half * Math.abs(axes.wz());
        return mz + halfDepth < 0 || mz - halfDepth > depth
            || isBesideWall(fx, fy, fz, half, axes.ux(), axes.uy(), axes.uz())
            || isBesideWall(fx, fy, fz, half, axes.vx(), axes.vy(), axes.vz());
    }

    /** Whether a box is beyond one of the two walls whose normals are depth a - halfWidth w and -depth a - halfWidth w. */
    private boolean isBesideWall(double fx, double fy, double fz, double half, double ax, double ay, double az) {
        double wx = halfWidth * axes.wx();
        double wy = halfWidth * axes.wy();
        double wz = halfWidth * axes.wz();
        double aside = depth * (fx * ax + fy * ay + fz * az);
        double inside = halfWidth * (fx * axes.wx() + fy * axes.wy() + fz * axes.wz());
        return aside - inside
            > half * Math.abs(depth * ax - wx) + half * Math.abs(depth * ay - wy) + half * Math.abs(depth * az - wz)
            || -aside - inside
            > half * Math.abs(depth * ax + wx) + half * Math.abs(depth * ay + wy) + half * Math.abs(depth * az + wz);
    }

    /**
     * The line to a point (x, y) of the square, in world axes; overwritten by the next. Most tests of a line need only (x, y),
     * so it is computed where one needs more, and once for all that need the same line.
     */
    Segment segmentTo(double x, double y) {
        if (x != segmentX || y != segmentY) {
            segmentX = x;
            segmentY = y;
            segment.connect(hit.origin(), endX(x, y), endY(x, y), endZ(x, y), endError);
        }
        return segment;
    }

    /** The point (x, y) of the square in world axes. */
    double endX(double x, double y) {
        return lx + (x * axes.ux() + y * axes.vx());
    }

    double endY(double x, double y) {
        return ly + (x * axes.uy() + y * axes.vy());
    }

    double endZ(double x, double y) {
        return lz + (x * axes.uz() + y * axes.vz());
    }
}
