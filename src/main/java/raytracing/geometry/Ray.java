package raytracing.geometry;

import raytracing.math.Vector;

/**
 * A half-line: the points origin + t direction with t above 0.
 *
 * @param origin start, world axes
 * @param originError how far each part of the origin may be off
 * @param direction where it goes; any length but 0, and distances t count in multiples of it
 * @param surfaceLeft number of the surface on which the ray starts, or {@link #NO_SURFACE}
 * @param departure to which side of that surface it leaves; {@link Departure#ELSEWHERE} if there is none
 */
public record Ray(Vector origin, double originError, Vector direction, int surfaceLeft, Departure departure) {
    /** The number of no surface at all, below every real one. */
    public static final int NO_SURFACE = -1;

    /**
     * A ray from a point that the scene names, such as the camera.
     *
     * @param origin start
     * @param direction where it goes, not zero
     */
    public Ray(Vector origin, Vector direction) {
        this(origin, PointError.written(origin), direction, NO_SURFACE,
            Departure.ELSEWHERE);
    }
}
