package raytracing.geometry;

import raytracing.math.Vector;

/**
 * What a ray found: the winner's details, computed once the nearest crossing is known.
 *
 * @param surface number of the surface, counted from 0 in the order of the scene
 * @param material number of its material, counted from 0
 * @param distance the crossing, in multiples of the ray's direction; above 0
 * @param point the crossing in world axes, rounded, on the surface as nearly as doubles allow
 * @param pointError how far each part of the point may be off
 * @param normal unit normal, turned towards the ray's origin
 * @param side how a ray leaves that starts here on the side from which this one came:
 *         {@link Departure#OUTWARD} or {@link Departure#INWARD}
 */
public record Hit(int surface, int material, double distance, Vector point, double pointError, Vector normal,
                  Departure side) {
    /**
     * How a straight line from here leaves this surface, by its direction alone.
     *
     * @param dx where the line goes, x part; any length
     * @param dy y part
     * @param dz z part
     * @return into the body, or out of it or along its wall
     */
    public Departure departureTowards(double dx, double dy, double dz) {
        return Departure.towards(side, normal.x() * dx + normal.y() * dy + normal.z() * dz);
    }

    /**
     * A ray that starts here, on the side from which this surface was seen.
     *
     * @param direction where it goes, not zero
     * @return a ray that will not meet this surface where it leaves it
     */
    public Ray leaving(Vector direction) {
        return new Ray(point, pointError, direction, surface, side);
    }
}
