package raytracing.geometry;

/**
 * How the origin of a ray lies to one surface. A mirrored ray and a shadow ray start on a surface, where rounding
 * would decide at random whether they meet that surface at once; so they carry what is known instead: which
 * surface they leave and to which side. All bodies are convex, and that makes the answer exact without any epsilon.
 */
public enum Departure {
    /** Off the surface: wherever its coordinates say. */
    ELSEWHERE,

    /** On the surface, leaving away from the body: the ray never meets this surface. */
    OUTWARD,

    /** On the surface, leaving into the body: only the far wall is ahead. */
    INWARD;

    /**
     * How a straight line leaves a surface from a hit, by its direction alone.
     *
     * @param seenFrom the side from which the hit was seen
     * @param alongNormal component of the line's direction along the hit's normal, which points to that side
     * @return into the body, or out of it or along its wall
     */
    static Departure towards(Departure seenFrom, double alongNormal) {
        boolean toTheSeenSide = alongNormal >= 0;
        return toTheSeenSide == (seenFrom == OUTWARD) ? OUTWARD : INWARD;
    }
}
