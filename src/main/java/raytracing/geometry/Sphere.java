package raytracing.geometry;

import raytracing.math.Vector;

/**
 * The scene line {@code sph}: all points at one distance from a centre.
 *
 * @param centre its middle, world axes
 * @param radius above 0, finite
 * @param material number of its material, from 0
 */
public record Sphere(Vector centre, double radius, int material) implements Surface {
    @Override
    public double firstCrossing(Vector origin, Vector direction, Departure departure) {
        Vector o = origin.minus(centre);
        return switch (departure) {
            case ELSEWHERE -> SphereKernel.firstCrossing(
                o.x(), o.y(), o.z(), direction.x(), direction.y(), direction.z(), radius);
            case INWARD -> SphereKernel.acrossFromInnerWall(
                o.x(), o.y(), o.z(), direction.x(), direction.y(), direction.z());
            case OUTWARD -> MISS;
        };
    }

    /**
     * Taken from (origin - centre) + t direction, which keeps its digits when both lie far from the world's origin. Of
     * a ball so small and far that nothing is left of this sum, the point nearest to the ray's origin is seen.
     */
    @Override
    public Vector outwardNormal(Vector origin, Vector direction, double distance) {
        Vector fromCentre = origin.minus(centre).plus(distance, direction);
        return fromCentre.isZero() ? direction.negated().unit() : fromCentre.unit();
    }

    @Override
    public void presentTo(Receiver receiver) {
        receiver.sphere(this);
    }
}
