package raytracing.geometry;

import raytracing.math.Vector;

/** The normal that points out of a body, whichever way the ray that met it went. */
public final class OutwardNormal {
    private OutwardNormal() {
    }

    /** Where a ray meets a surface, at a distance that the surface has found. */
    public static Vector of(Surface surface, Ray ray, double distance) {
        Hit hit = surface.hit(ray, distance, 0);
        Vector normal = hit.side() == Departure.OUTWARD ? hit.normal() : hit.normal().negated();
        return normal.plus(Vector.ZERO);     // no negative zeros
    }
}
