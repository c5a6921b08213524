package raytracing.shade;

import java.util.Comparator;
import java.util.Optional;
import java.util.PriorityQueue;
import raytracing.color.Color;
import raytracing.geometry.Ray;

/**
 * The mirrored rays of one pixel that still have to be followed, the one with the greatest weight first. One thread.
 *
 * <p>In a hall of transparent mirrors every ray splits at every wall, and following all of them would take time that
 * grows exponentially with the recursion limit. So the number of those that are followed is limited; as the heaviest go
 * first, what is left out is what weighs least.
 */
final class Branches {
    /** Mirrored rays that one pixel may follow. Ordinary scenes need about as many as their recursion limit. */
    static final int MOST_FOLLOWED = 1000;

    private static final Comparator<Branch> HEAVIEST_FIRST =
        Comparator.comparingDouble((Branch branch) -> -branch.weight.max()).thenComparingInt(Branch::order);

    /**
     * A ray to follow.
     *
     * @param ray where it starts and goes; unit direction
     * @param weight factor on whatever it sees, in the pixel
     * @param reflections how often light was mirrored between this ray and the eye
     * @param key of its random numbers
     * @param order by which equal weights are sorted, so that the picture depends on no chance
     */
    record Branch(Ray ray, Color weight, int reflections, long key, int order) {
    }

    private final PriorityQueue<Branch> waiting = new PriorityQueue<>(1, HEAVIEST_FIRST);
    private int followed;
    private int added;

    void add(Ray ray, Color weight, int reflections, long key) {
        waiting.add(new Branch(ray, weight, reflections, key, added++));
    }

    /** The heaviest branch while the limit allows. */
    Optional<Branch> next() {
        if (waiting.isEmpty() || followed == MOST_FOLLOWED) {
            return Optional.empty();
        }
        followed++;
        return Optional.of(waiting.remove());
    }

    /** After the last {@link #next}: what the limit left out, one after the other. */
    Optional<Branch> nextLeftOut() {
        return Optional.ofNullable(waiting.poll());
    }
}
