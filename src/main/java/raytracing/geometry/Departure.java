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
    INWARD
}
