package raytracing.surface;

/** The queries of a scene's lists, put to a single surface: doubles first, and exact numbers where these leave it open. */
public final class SurfaceQuestions {
    private SurfaceQuestions() {
    }

    /**
     * Where a ray first meets a surface. A ray that starts inside a body meets its wall from inside.
     *
     * @param departure how the ray's origin lies to the surface
     */
    public static double firstCrossing(Surface surface, RayRecord ray, Departure departure) {
        double quick = quickCrossing(surface, ray, departure);
        if (!Double.isNaN(quick)) {
            return quick;
        }
        int number = departure == Departure.ELSEWHERE ? ray.surfaceLeft() + 1 : ray.surfaceLeft();
        return Surface.distance(surface.exactCrossing(leaving(ray, departure), number));
    }

    /** The same in doubles alone. */
    static double quickCrossing(Surface surface, RayRecord ray, Departure departure) {
        return switch (departure) {
            case OUTWARD -> Surface.MISS;
            case INWARD -> surface instanceof Body body ? body.farWall(leaving(ray, departure)) : Surface.MISS;
            case ELSEWHERE -> surface.firstCrossing(ray.toRay(), Surface.MISS);
        };
    }

    private static Ray leaving(RayRecord ray, Departure departure) {
        return new RayRecord(ray.origin(), ray.originError(), ray.direction(), ray.surfaceLeft(), departure).toRay();
    }

    /**
     * Whether a surface lies between two points.
     *
     * @param departure how the segment's start lies to the surface
     */
    public static boolean crosses(Surface surface, SegmentRecord segment, Departure departure) {
        return switch (departure) {
            case OUTWARD -> false;
            case INWARD -> surface instanceof Body body && body.isLeft(segment.toSegment());
            case ELSEWHERE -> surface.isCrossed(segment.toSegment(), 0);
        };
    }
}
