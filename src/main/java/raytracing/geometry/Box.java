package raytracing.geometry;

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

    private static final int X_ENTRY = 0;
    private static final int Y_ENTRY = 1;
    private static final int Z_ENTRY = 2;
    private static final int X_EXIT = 3;
    private static final int Y_EXIT = 4;
    private static final int Z_EXIT = 5;

    @Override
    public double firstCrossing(Ray ray, Departure departure) {
        Vector o = ray.origin();
        Vector d = ray.direction();
        return switch (departure) {
            case ELSEWHERE -> BoxKernel.firstCrossing(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), ray.originError(),
                centre.x(), centre.y(), centre.z(), edge / 2);
            case INWARD -> farWall(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
            case OUTWARD -> MISS;
        };
    }

    @Override
    public double farWall(double ox, double oy, double oz, double dx, double dy, double dz) {
        return BoxKernel.acrossFromInnerWall(ox, oy, oz, dx, dy, dz, centre.x(), centre.y(), centre.z(), edge / 2);
    }

    @Override
    public boolean crosses(Segment segment, Departure departure) {
        Vector p = segment.start();
        Vector q = segment.end();
        return switch (departure) {
            case ELSEWHERE -> BoxKernel.crossesBetween(p.x(), p.y(), p.z(), segment.startError(),
                q.x(), q.y(), q.z(), segment.endError(), centre.x(), centre.y(), centre.z(), edge / 2);
            case INWARD -> isLeftBefore(q.x(), q.y(), q.z(), segment.endError());
            case OUTWARD -> false;
        };
    }

    @Override
    public boolean isLeftBefore(double qx, double qy, double qz, double endError) {
        return BoxKernel.isOutside(qx, qy, qz, endError, centre.x(), centre.y(), centre.z(), edge / 2);
    }

    @Override
    public boolean isApartFrom(double x, double y, double z, double r) {
        double furthest = Vector.largestPart(x - centre.x(), y - centre.y(), z - centre.z());
        return furthest > (1 + ROUNDING) * (edge / 2 + r);
    }

    /** The point is on the face to the last bit, and within its edges. */
    @Override
    public void describe(double ox, double oy, double oz, double dx, double dy, double dz, double distance,
                         HitPoint found) {
        int face = face(ox, oy, oz, dx, dy, dz, distance);
        double nx = face == X_ENTRY ? -Math.copySign(1, dx) : face == X_EXIT ? Math.copySign(1, dx) : 0;
        double ny = face == Y_ENTRY ? -Math.copySign(1, dy) : face == Y_EXIT ? Math.copySign(1, dy) : 0;
        double nz = face == Z_ENTRY ? -Math.copySign(1, dz) : face == Z_EXIT ? Math.copySign(1, dz) : 0;
        double error = PointError.ofCrossing(Vector.largestPart(ox, oy, oz) + distance * Vector.largestPart(dx, dy, dz));
        found.place(onFace(ox + distance * dx, centre.x(), nx), onFace(oy + distance * dy, centre.y(), ny),
            onFace(oz + distance * dz, centre.z(), nz), error);
        found.turn(nx, ny, nz, dx, dy, dz);
    }

    /**
     * The face that the ray passes at that distance. On an edge it is a face through which the ray comes in, if there
     * is one, and the first of x, y, z.
     */
    private int face(double ox, double oy, double oz, double dx, double dy, double dz, double distance) {
        double half = edge / 2;
        double enterX = off(ox, dx, centre.x(), -half, distance);
        double enterY = off(oy, dy, centre.y(), -half, distance);
        double enterZ = off(oz, dz, centre.z(), -half, distance);
        double leaveX = off(ox, dx, centre.x(), half, distance);
        double leaveY = off(oy, dy, centre.y(), half, distance);
        double leaveZ = off(oz, dz, centre.z(), half, distance);
        double leave = Math.min(leaveX, Math.min(leaveY, leaveZ));
        if (Math.min(enterX, Math.min(enterY, enterZ)) <= leave) {
            return enterX <= enterY && enterX <= enterZ ? X_ENTRY : enterY <= enterZ ? Y_ENTRY : Z_ENTRY;
        }
        return leaveX <= leaveY && leaveX <= leaveZ ? X_EXIT : leaveY <= leaveZ ? Y_EXIT : Z_EXIT;
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
