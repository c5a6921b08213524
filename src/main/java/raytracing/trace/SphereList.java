package raytracing.trace;

import java.util.Optional;
import raytracing.hierarchy.Hierarchy;
import raytracing.surface.Body;
import raytracing.surface.Ray;
import raytracing.surface.RayOrigin;
import raytracing.surface.Segment;
import raytracing.surface.Sphere;

/** The spheres of a scene. */
public final class SphereList extends SurfaceList {
    private final Sphere[] spheres;
    private final double[] packed;

    /** @param packed of each sphere, in the same order: most lines pass most spheres, which then are not looked up */
    SphereList(Sphere[] spheres, double[] packed, int[] numbers, Optional<Hierarchy> hierarchy) {
        super(numbers, hierarchy);
        this.spheres = spheres;
        this.packed = packed;
    }

    public Sphere[] spheres() {
        return spheres;
    }

    /** Where each sphere is and how large, as {@link Sphere#pack} writes it. */
    public double[] packed() {
        return packed;
    }

    @Override
    void offerCrossings(Ray ray, int from, int to, Crossings crossings) {
        int[] number = numbers();
        double[] bodies = packed;
        RayOrigin o = ray.origin();
        int start = o.surface();
        double ox = o.x();
        double oy = o.y();
        double oz = o.z();
        double dx = ray.dx();
        double dy = ray.dy();
        double dz = ray.dz();
        double error = o.error();
        for (int i = from; i < to; i++) {
            if (!Sphere.isPlainlyMissed(bodies, Body.PACKED * i, ox, oy, oz, dx, dy, dz, error) && number[i] != start) {
                crossings.offer(spheres[i].firstCrossing(ray, crossings.latest()), number[i]);
            }
        }
    }

    @Override
    int addCrossed(Segment segment, int from, int to, CrossedSurfaces crossed, int last) {
        int[] number = numbers();
        double[] bodies = packed;
        RayOrigin o = segment.start();
        int start = o.surface();
        double ox = o.x();
        double oy = o.y();
        double oz = o.z();
        double dx = segment.dx();
        double dy = segment.dy();
        double dz = segment.dz();
        double error = segment.error();
        int opaque = last;
        for (int i = from; i < to && !crossed.isDark(); i++) {
            if (!Sphere.isPlainlyMissed(bodies, Body.PACKED * i, ox, oy, oz, dx, dy, dz, error) && number[i] != start
                    && spheres[i].isCrossedClosely(segment, number[i])) {
                crossed.add(number[i]);
                opaque = crossed.isDark() ? i : opaque;
            }
        }
        return opaque;
    }
}
