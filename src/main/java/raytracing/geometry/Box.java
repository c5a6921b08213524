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
        double ox = origin.x() - centre.x();
        double oy = origin.y() - centre.y();
        double oz = origin.z() - centre.z();
        return switch (departure) {
            case ELSEWHERE -> BoxKernel.firstCrossing(
                ox, oy, oz, direction.x(), direction.y(), direction.z(), edge / 2);
            case INWARD -> BoxKernel.acrossFromInnerWall(
                ox, oy, oz, direction.x(), direction.y(), direction.z(), edge / 2);
            case OUTWARD -> MISS;
        };
    }

    /** The axis of the face that the ray crosses at that distance; on an edge, the first of x, y, z. */
    @Override
    public Vector outwardNormal(Vector origin, Vector direction, double distance) {
        double half = edge / 2;
        double ox = origin.x() - centre.x();
        double oy = origin.y() - centre.y();
        double oz = origin.z() - centre.z();
        if (BoxKernel.crosses(-half, ox, direction.x(), distance)) {
            return new Vector(-1, 0, 0);
        }
        if (BoxKernel.crosses(half, ox, direction.x(), distance)) {
            return new Vector(1, 0, 0);
        }
        if (BoxKernel.crosses(-half, oy, direction.y(), distance)) {
            return new Vector(0, -1, 0);
        }
        if (BoxKernel.crosses(half, oy, direction.y(), distance)) {
            return new Vector(0, 1, 0);
        }
        return new Vector(0, 0, BoxKernel.crosses(half, oz, direction.z(), distance) ? 1 : -1);
    }

    @Override
    public void presentTo(Receiver receiver) {
        receiver.box(this);
    }
}
