package raytracing.trace;

import java.util.Optional;
import raytracing.hierarchy.Hierarchy;
import raytracing.hierarchy.RayTraversal;
import raytracing.surface.Ray;
import raytracing.surface.RayOrigin;
import raytracing.surface.Segment;

/**
 * The surfaces of one kind, tested one after the other or, if there are many, through a hierarchy whose leaves are ranges of
 * the list. Each kind has a list of its own, so that the calls in its loops have a single receiver, which the virtual machine
 * can inline. Immutable.
 */
public abstract class SurfaceList {
    /** "No surface stopped the light", an entry beyond all lists. */
    static final int NONE = Integer.MAX_VALUE;

    private final int[] numbers;
    private final Optional<Hierarchy> hierarchy;

    /** Surfaces with these numbers in the scene, in the order of the hierarchy, if there is one. */
    SurfaceList(int[] numbers, Optional<Hierarchy> hierarchy) {
        this.numbers = numbers;
        this.hierarchy = hierarchy;
    }

    /** The number in the scene of each surface of the list. */
    public final int[] numbers() {
        return numbers;
    }

    public final Optional<Hierarchy> hierarchy() {
        return hierarchy;
    }

    /** Offers the first crossing of a ray with every surface but the one on which it starts. */
    final void offerCrossings(Ray ray, RayTraversal traversal, Crossings crossings) {
        if (hierarchy.isEmpty()) {
            offerAll(ray, crossings);
            return;
        }
        RayOrigin o = ray.origin();
        traversal.startRay(hierarchy.get(), o.x(), o.y(), o.z(), o.error(), ray.dx(), ray.dy(), ray.dz());
        while (traversal.nextLeaf(crossings.distance())) {
            offerCrossings(ray, traversal.from(), traversal.to(), crossings);
        }
    }

    /**
     * Adds all surfaces that a segment crosses, but for the one on which it starts; may stop when no light is left.
     *
     * @param last entry of the surface that stopped the light last, which is tested first: segments that are tested one after
     *        the other are often stopped by the same; {@link #NONE} if there is none
     * @return entry of the surface that stopped the light, or {@code last}
     */
    final int addCrossed(Segment segment, RayTraversal traversal, CrossedSurfaces crossed, int last) {
        if (hierarchy.isEmpty()) {
            return addAllCrossed(segment, crossed, last);
        }
        if (last < numbers.length) {
            addCrossed(segment, last, last + 1, crossed, last);
        }
        if (crossed.isDark()) {
            return last;
        }
        RayOrigin o = segment.start();
        traversal.startRay(hierarchy.get(), o.x(), o.y(), o.z(), segment.error(), segment.dx(), segment.dy(), segment.dz());
        int opaque = last;
        while (!crossed.isDark() && traversal.nextLeaf(1)) {
            opaque = addCrossed(segment, traversal.from(), traversal.to(), crossed, opaque);
        }
        return opaque;
    }

    /** The same for a list without a hierarchy; an empty one is asked too (DECISIONS). */
    void offerAll(Ray ray, Crossings crossings) {
        offerCrossings(ray, 0, numbers.length, crossings);
    }

    int addAllCrossed(Segment segment, CrossedSurfaces crossed, int last) {
        return addCrossed(segment, 0, numbers.length, crossed, last);
    }

    /** Offers the first crossing of a ray with each of a range of entries, but for the surface on which it starts. */
    abstract void offerCrossings(Ray ray, int from, int to, Crossings crossings);

    /** Adds those of a range of entries that a segment crosses; returns the entry that stopped the light, or {@code last}. */
    abstract int addCrossed(Segment segment, int from, int to, CrossedSurfaces crossed, int last);
}
