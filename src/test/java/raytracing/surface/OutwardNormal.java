package raytracing.surface;

import raytracing.math.Vector;
import raytracing.math.Vectors;

/** The normal that points out of a body, whichever way the ray that met it went. */
public final class OutwardNormal {
    private OutwardNormal() {
    }

    /** Where a ray meets a surface, at a distance that the surface has found. */
    public static Vector of(Surface surface, RayRecord ray, double distance) {
        HitRecord hit = HitRecord.at(surface, ray, distance, 0);
        Vector normal = hit.side() == Departure.OUTWARD ? hit.normal() : Vectors.negated(hit.normal());
        return Vectors.plus(normal, Vector.ZERO);     // no negative zeros
    }
}
