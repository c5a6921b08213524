package raytracing.trace;

import java.util.Optional;
import raytracing.surface.Plane;
import raytracing.surface.Ray;
import raytracing.surface.Segment;

/** The planes of a scene. */
public final class PlaneList extends SurfaceList {
    private final Plane[] planes;

    PlaneList(Plane[] planes, int[] numbers) {
        super(numbers, Optional.empty());   // endless planes have no bounds
        this.planes = planes;
    }

    public Plane[] planes() {
        return planes;
    }

    @Override
    void offerCrossings(Ray ray, int from, int to, Crossings crossings) {
        int[] number = numbers();
        int start = ray.origin().surface();
        for (int i = from; i < to; i++) {
            if (number[i] != start) {
                crossings.offer(planes[i].firstCrossing(ray, crossings.latest()), number[i]);
            }
        }
    }

    @Override
    int addCrossed(Segment segment, int from, int to, CrossedSurfaces crossed, int last) {
        int[] number = numbers();
        int start = segment.start().surface();
        int opaque = last;
        for (int i = from; i < to && !crossed.isDark(); i++) {
            if (number[i] != start && planes[i].isCrossed(segment, number[i])) {
                crossed.add(number[i]);
                opaque = crossed.isDark() ? i : opaque;
            }
        }
        return opaque;
    }
}
