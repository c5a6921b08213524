package raytracing.trace;

import java.util.Optional;
import raytracing.hierarchy.Hierarchy;
import raytracing.surface.Ray;
import raytracing.surface.Segment;
import raytracing.surface.Triangle;

/** The triangles of a scene. */
public final class TriangleList extends SurfaceList {
    private final Triangle[] triangles;

    TriangleList(Triangle[] triangles, int[] numbers, Optional<Hierarchy> hierarchy) {
        super(numbers, hierarchy);
        this.triangles = triangles;
    }

    public Triangle[] triangles() {
        return triangles;
    }

    @Override
    void offerCrossings(Ray ray, int from, int to, Crossings crossings) {
        int[] number = numbers();
        int start = ray.origin().surface();
        for (int i = from; i < to; i++) {
            if (number[i] != start) {
                crossings.offer(triangles[i].firstCrossing(ray, crossings.latest()), number[i]);
            }
        }
    }

    @Override
    int addCrossed(Segment segment, int from, int to, CrossedSurfaces crossed, int last) {
        int[] number = numbers();
        int start = segment.start().surface();
        int opaque = last;
        for (int i = from; i < to && !crossed.isDark(); i++) {
            if (number[i] != start && triangles[i].isCrossed(segment, number[i])) {
                crossed.add(number[i]);
                opaque = crossed.isDark() ? i : opaque;
            }
        }
        return opaque;
    }
}
