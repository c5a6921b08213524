package raytracing.shade;

/**
 * How many rays a picture took, by kind, and how many it did without.
 *
 * @param eye rays from the eye
 * @param mirrored rays sent on by mirrors
 * @param mirroredLeftOut mirrored rays that were not followed, as too little of them would be seen
 * @param surfacesMet surfaces that all of these met
 * @param lightsAtPoints pairs of a light and a point of a surface that is not wholly transparent
 * @param lightsAsked those of them where it matters how much of the light arrives: the surface faces the light and shows it
 * @param lightsSettled those of the asked for which no shadow ray was needed: everything is beside the light's shaft, or in
 *        the way of all of it
 * @param shadowRays lines from points to lights along which surfaces were asked for
 * @param shadowAreas soft shadows found by areas
 */
public record RayCounts(long eye, long mirrored, long mirroredLeftOut, long surfacesMet, long lightsAtPoints,
                        long lightsAsked, long lightsSettled, long shadowRays, long shadowAreas) {
    /** Before the first ray. */
    public static final RayCounts NONE = new RayCounts(0, 0, 0, 0, 0, 0, 0, 0, 0);

    /**
     * Counts together.
     *
     * @param other counts of other rays
     * @return of both
     */
    public RayCounts plus(RayCounts other) {
        return new RayCounts(eye + other.eye, mirrored + other.mirrored, mirroredLeftOut + other.mirroredLeftOut,
            surfacesMet + other.surfacesMet, lightsAtPoints + other.lightsAtPoints, lightsAsked + other.lightsAsked,
            lightsSettled + other.lightsSettled, shadowRays + other.shadowRays, shadowAreas + other.shadowAreas);
    }
}
