package raytracing.trace;

import java.util.Optional;
import raytracing.hierarchy.Hierarchy;
import raytracing.hierarchy.RayTraversal;
import raytracing.surface.Body;
import raytracing.surface.Box;
import raytracing.surface.Ray;
import raytracing.surface.RayOrigin;
import raytracing.surface.Segment;

/** The boxes of a scene. */
public final class BoxList extends SurfaceList {
    private final Box[] boxes;
    private final double[] packed;

    /** @param packed of each box, in the same order: most lines pass most boxes, which then are not looked up */
    BoxList(Box[] boxes, double[] packed, int[] numbers, Optional<Hierarchy> hierarchy) {
        super(numbers, hierarchy);
        this.boxes = boxes;
        this.packed = packed;
    }

    public Box[] boxes() {
        return boxes;
    }

    /**
     * Of some faces that meet in an edge or corner of a box, those in whose planes the boxes that touch it there have faces
     * too, through which a ray enters.
     *
     * @param faces a bit 1 &lt;&lt; axis for each, with axis 0 for x, 1 for y, 2 for z
     * @param point where the ray meets the edge
     * @return all of the faces if no such plane is shared
     */
    int sharedFaces(int faces, RayOrigin point, Ray ray, RayTraversal traversal) {
        if (hierarchy().isEmpty()) {
            return sharedFaces(faces, point, ray, 0, boxes.length);
        }
        int shared = faces;
        traversal.startRay(hierarchy().get(), point.x(), point.y(), point.z(), point.error(), ray.dx(), ray.dy(), ray.dz());
        while (traversal.nextLeaf(0)) {
            shared = sharedFaces(shared, point, ray, traversal.from(), traversal.to());
        }
        return shared;
    }

    private int sharedFaces(int faces, RayOrigin point, Ray ray, int from, int to) {
        int shared = faces;
        for (int i = from; i < to; i++) {
            int others = boxes[i].facesEntered(point, ray);
            shared = (shared & others) == 0 ? shared : shared & others;
        }
        return shared;
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
            if (!Box.isPlainlyMissed(bodies, Body.PACKED * i, ox, oy, oz, dx, dy, dz, crossings.latest(), error)
                    && number[i] != start) {
                crossings.offer(boxes[i].firstCrossing(ray, crossings.latest()), number[i]);
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
            if (!Box.isPlainlyMissed(bodies, Body.PACKED * i, ox, oy, oz, dx, dy, dz, 1, error) && number[i] != start
                    && boxes[i].isCrossedClosely(segment, number[i])) {
                crossed.add(number[i]);
                opaque = crossed.isDark() ? i : opaque;
            }
        }
        return opaque;
    }
}
