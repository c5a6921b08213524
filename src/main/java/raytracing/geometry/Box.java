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
    @Override
    public double firstCrossing(Ray ray, Departure departure) {
        Vector o = ray.origin();
        Vector d = ray.direction();
        return switch (departure) {
            case ELSEWHERE -> BoxKernel.firstCrossing(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), ray.originError(),
                centre.x(), centre.y(), centre.z(), edge / 2);
            case INWARD -> BoxKernel.acrossFromInnerWall(o.x(), o.y(), o.z(), d.x(), d.y(), d.z(),
                centre.x(), centre.y(), centre.z(), edge / 2);
            case OUTWARD -> MISS;
        };
    }

    @Override
    public boolean crosses(Segment segment, Departure departure) {
        Vector p = segment.start();
        Vector q = segment.end();
        return switch (departure) {
            case ELSEWHERE -> BoxKernel.crossesBetween(p.x(), p.y(), p.z(), segment.startError(),
                q.x(), q.y(), q.z(), segment.endError(), centre.x(), centre.y(), centre.z(), edge / 2);
            case INWARD -> BoxKernel.isOutside(q.x(), q.y(), q.z(), segment.endError(),
                centre.x(), centre.y(), centre.z(), edge / 2);
            case OUTWARD -> false;
        };
    }

    /**
     * The axis of the face that the ray passes at that distance. On an edge it is a face through which the ray comes in, if
     * there is one, and the first of x, y, z.
     */
    @Override
    public Vector outwardNormal(Ray ray, double distance) {
        Vector o = ray.origin();
        Vector d = ray.direction();
        double half = edge / 2;
        double enterX = off(o.x(), d.x(), centre.x(), -half, distance);
        double enterY = off(o.y(), d.y(), centre.y(), -half, distance);
        double enterZ = off(o.z(), d.z(), centre.z(), -half, distance);
        double leaveX = off(o.x(), d.x(), centre.x(), half, distance);
        double leaveY = off(o.y(), d.y(), centre.y(), half, distance);
        double leaveZ = off(o.z(), d.z(), centre.z(), half, distance);
        double leave = Math.min(leaveX, Math.min(leaveY, leaveZ));
        return Math.min(enterX, Math.min(enterY, enterZ)) <= leave
            ? axis(d.negated(), enterX, enterY, enterZ)
            : axis(d, leaveX, leaveY, leaveZ);
    }

    /** How far from this distance the ray passes a face's plane: 0 for the face that it meets there. */
    private static double off(double o, double d, double c, double towards, double distance) {
        return d == 0 ? MISS : Math.abs(BoxKernel.crossing(o, d, c, towards) - distance);
    }

    /** The axis with the least number, in a vector's sense along it. */
    private static Vector axis(Vector sense, double x, double y, double z) {
        if (x <= y && x <= z) {
            return new Vector(Math.copySign(1, sense.x()), 0, 0);
        }
        return y <= z ? new Vector(0, Math.copySign(1, sense.y()), 0) : new Vector(0, 0, Math.copySign(1, sense.z()));
    }

    /** On the face to the last bit, and within its edges. */
    @Override
    public Vector point(Ray ray, double distance, Vector outwardNormal) {
        Vector along = ray.origin().plus(distance, ray.direction());
        return new Vector(
            onFace(along.x(), centre.x(), outwardNormal.x()),
            onFace(along.y(), centre.y(), outwardNormal.y()),
            onFace(along.z(), centre.z(), outwardNormal.z()));
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
