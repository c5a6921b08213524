package raytracing.surface;

/**
 * How the origin of a ray lies to one surface. A mirrored ray and a shadow ray start on a surface, where rounding
 * would decide at random whether they meet that surface at once. So they keep which surface they leave and to which side.
 * All bodies are convex, so this decides exactly, without any epsilon.
 */
public enum Departure {
    /** Not on the surface, or on it without a known side: its coordinates tell. */
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
