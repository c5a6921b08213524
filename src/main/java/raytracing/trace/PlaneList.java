package raytracing.trace;

import java.util.Optional;
import raytracing.surface.Plane;
import raytracing.surface.Ray;
import raytracing.surface.RayOrigin;
import raytracing.surface.Segment;

/** The planes of a scene, many of them in groups. */
public final class PlaneList extends SurfaceList {
    private final Plane[] planes;
    private final Optional<PlaneGroups> groups;

    /** Planes with these numbers in the scene, in the order of the groups, if there are some. */
    PlaneList(Plane[] planes, int[] numbers, Optional<PlaneGroups> groups) {
        super(numbers, Optional.empty());   // endless planes have no bounds
        this.planes = planes;
        this.groups = groups;
    }

    public Plane[] planes() {
        return planes;
    }

    public Optional<PlaneGroups> groups() {
        return groups;
    }

    @Override
    void offerAll(Ray ray, Crossings crossings) {
        if (groups.isEmpty()) {
            super.offerAll(ray, crossings);
        } else {
            offerGroups(groups.get(), ray, crossings);
        }
    }

    private void offerGroups(PlaneGroups all, Ray ray, Crossings crossings) {
        RayOrigin o = ray.origin();
        long place = PlaneGroups.START;
        do {
            place = all.next(place, o.x(), o.y(), o.z(), o.error(), ray.dx(), ray.dy(), ray.dz(), 0, crossings.latest());
            if (place != PlaneGroups.END) {
                offerCrossings(ray, all.from(place), all.to(place), crossings);
            }
        } while (place != PlaneGroups.END);
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
    int addAllCrossed(Segment segment, CrossedSurfaces crossed, int last) {
        if (groups.isEmpty()) {
            return super.addAllCrossed(segment, crossed, last);
        }
        if (last < planes.length) {
            addCrossed(segment, last, last + 1, crossed, last);
        }
        return crossed.isDark() ? last : addCrossedOfGroups(groups.get(), segment, crossed, last);
    }

    private int addCrossedOfGroups(PlaneGroups all, Segment segment, CrossedSurfaces crossed, int last) {
        RayOrigin o = segment.start();
        int opaque = last;
        long place = PlaneGroups.START;
        do {
            place = all.next(place, o.x(), o.y(), o.z(), segment.error(), segment.dx(), segment.dy(), segment.dz(), 0, 1);
            if (place != PlaneGroups.END) {
                opaque = addCrossed(segment, all.from(place), all.to(place), crossed, opaque);
            }
        } while (place != PlaneGroups.END && !crossed.isDark());
        return opaque;
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
