package raytracing.geometry;

import raytracing.math.Vector;

/**
 * The scene line {@code pln}: the points P with P . normal = offset, endless and with two sides. The normal is kept
 * as the scene wrote it, for making it a unit vector would move the plane by a rounding.
 *
 * @param normal perpendicular to the plane; any length but 0
 * @param offset the dot product that its points share: distance from the world's origin times |normal|
 * @param material number of its material, from 0
 */
public record Plane(Vector normal, double offset, int material) implements Surface {
    @Override
    public double firstCrossing(Vector origin, Vector direction, Departure departure) {
        if (departure != Departure.ELSEWHERE) {
            return MISS;                     // a straight line leaves a plane once
        }
        return PlaneKernel.firstCrossing(normal.x(), normal.y(), normal.z(), offset,
            origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
    }

    @Override
    public Vector outwardNormal(Vector origin, Vector direction, double distance) {
        return normal.unit();
    }

    @Override
    public void presentTo(Receiver receiver) {
        receiver.plane(this);
    }
}
