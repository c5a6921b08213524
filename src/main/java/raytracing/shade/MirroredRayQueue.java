package raytracing.shade;

import java.util.ArrayList;
import java.util.List;
import java.util.PriorityQueue;
import raytracing.color.MutableColor;
import raytracing.math.UnitVector;
import raytracing.surface.Ray;
import raytracing.surface.RayOrigin;

/**
 * The mirrored rays of one pixel that still have to be followed, the one with the greatest weight first. Its objects are
 * used again for the next pixel, so that rays do not allocate. Not thread-safe.
 *
 * <p>In a hall of transparent mirrors every ray splits at every wall, and following all of them would take time that
 * grows exponentially with the recursion limit. So the work for a pixel is limited; as the heaviest rays go first,
 * those that are left out weigh least.
 */
final class MirroredRayQueue {
    private final PriorityQueue<MirroredRay> waiting = new PriorityQueue<>();
    private final List<MirroredRay> rays = new ArrayList<>();
    private int added;

    /** A ray and its weight in the pixel. Of equal weights the older ray goes first, so that the order is always the same. */
    static final class MirroredRay implements Comparable<MirroredRay> {
        final Ray ray = new Ray();

        /** Factor on the light that arrives along the ray, in the pixel. */
        final MutableColor weight = new MutableColor();

        /** How often light was mirrored between this ray and the eye. */
        int reflections;

        /** Key of the ray's random numbers. */
        long key;

        private final int number;
        private double greatestWeight;

        private MirroredRay(int number) {
            this.number = number;
        }

        @Override
        public int compareTo(MirroredRay other) {
            int byWeight = Double.compare(other.greatestWeight, greatestWeight);
            return byWeight != 0 ? byWeight : Integer.compare(number, other.number);
        }
    }

    /** Removes all rays, for a new pixel. */
    void clear() {
        waiting.clear();
        added = 0;
    }

    /** Adds a ray that leaves a hit on the side from which it was seen. */
    void add(RayOrigin from, UnitVector direction, MutableColor weight, int reflections, long key) {
        if (added == rays.size()) {
            rays.add(new MirroredRay(added));
        }
        MirroredRay mirrored = rays.get(added++);
        mirrored.ray.leave(from, direction.x(), direction.y(), direction.z());
        mirrored.weight.set(weight);
        mirrored.greatestWeight = weight.max();
        mirrored.reflections = reflections;
        mirrored.key = key;
        waiting.add(mirrored);
    }

    /** All rays that wait, in an order that is the same every time and means nothing. */
    Iterable<MirroredRay> waiting() {
        return waiting;
    }

    boolean isEmpty() {
        return waiting.isEmpty();
    }

    /** Removes the heaviest ray, which is not overwritten until the next pixel. */
    MirroredRay remove() {
        return waiting.remove();
    }
}
