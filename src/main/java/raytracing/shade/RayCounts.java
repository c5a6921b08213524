package raytracing.shade;

/**
 * How many rays a picture took, by kind, and how many it did without.
 *
 * @param eye rays from the eye
 * @param mirrored rays from mirrors
 * @param mirroredLeftOut mirrored rays that were not followed, as too little of them would be seen
 * @param surfacesMet surfaces that all of these met
 * @param lightsAtPoints pairs of a light and a point of a surface that is not wholly transparent
 * @param shadowQueries those of them for which a shadow was computed: the surface faces the light and shows it
 * @param lightsSettled those shadows that needed no shadow ray: each surface is outside the light's shaft or blocks all of it
 * @param shadowRays lines from points to lights that were tested for surfaces in the way
 * @param shadowAreas soft shadows computed as areas
 */
public record RayCounts(long eye, long mirrored, long mirroredLeftOut, long surfacesMet, long lightsAtPoints,
                        long shadowQueries, long lightsSettled, long shadowRays, long shadowAreas) {
    public static final RayCounts NONE = new RayCounts(0, 0, 0, 0, 0, 0, 0, 0, 0);

    /** The sums of both. */
    public RayCounts plus(RayCounts other) {
        return new RayCounts(eye + other.eye, mirrored + other.mirrored, mirroredLeftOut + other.mirroredLeftOut,
            surfacesMet + other.surfacesMet, lightsAtPoints + other.lightsAtPoints, shadowQueries + other.shadowQueries,
            lightsSettled + other.lightsSettled, shadowRays + other.shadowRays, shadowAreas + other.shadowAreas);
    }
}
