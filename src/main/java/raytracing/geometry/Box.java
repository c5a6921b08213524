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
    public double firstCrossing(Vector origin, Vector direction, Departure departure) {
        Vector o = origin.minus(centre);
        return switch (departure) {
            case ELSEWHERE -> BoxKernel.firstCrossing(
                o.x(), o.y(), o.z(), direction.x(), direction.y(), direction.z(), edge / 2);
            case INWARD -> BoxKernel.acrossFromInnerWall(
                o.x(), o.y(), o.z(), direction.x(), direction.y(), direction.z(), edge / 2);
            case OUTWARD -> MISS;
        };
    }

    /** The axis of the face that the ray crosses at that distance; on an edge, the first of x, y, z. */
    @Override
    public Vector outwardNormal(Vector origin, Vector direction, double distance) {
        double half = edge / 2;
        Vector o = origin.minus(centre);
        if (BoxKernel.crosses(-half, o.x(), direction.x(), distance)) {
            return new Vector(-1, 0, 0);
        }
        if (BoxKernel.crosses(half, o.x(), direction.x(), distance)) {
            return new Vector(1, 0, 0);
        }
        if (BoxKernel.crosses(-half, o.y(), direction.y(), distance)) {
            return new Vector(0, -1, 0);
        }
        if (BoxKernel.crosses(half, o.y(), direction.y(), distance)) {
            return new Vector(0, 1, 0);
        }
        return new Vector(0, 0, BoxKernel.crosses(half, o.z(), direction.z(), distance) ? 1 : -1);
    }

    @Override
    public void presentTo(Receiver receiver) {
        receiver.box(this);
    }
}
