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
 * grows exponentially with the recursion limit. So a ray of negligible weight is not followed, and the number of those
 * that are is limited; as the heaviest go first, what is left out is always what weighs least. The shader puts the
 * background in its place, as the exercise does beyond its recursion limit.
 */
final class Branches {
    /**
     * A weight that no 8-bit channel shows: light of 1 adds less than a sixteenth of a step of 1/255. This bounds what
     * a single ray left out can change (proved); many of them add up. On the scenes of this project no pixel differs by
     * more than one step from the picture with none left out (measured in {@code LeftOutLightTest}).
     */
    static final double NEGLIGIBLE_WEIGHT = 0x1p-12;

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

    private final double negligibleWeight;
    private final PriorityQueue<Branch> waiting = new PriorityQueue<>(1, HEAVIEST_FIRST);
    private final LightSum leftOut = new LightSum();
    private int followed;
    private int added;

    /** No branches yet; rays below this weight will be left out. */
    Branches(double negligibleWeight) {
        this.negligibleWeight = negligibleWeight;
    }

    boolean isNegligible(Color weight) {
        return weight.max() < negligibleWeight;
    }

    void add(Ray ray, Color weight, int reflections, long key) {
        if (isNegligible(weight)) {
            leftOut.add(1, weight, Color.WHITE);
        } else {
            waiting.add(new Branch(ray, weight, reflections, key, added++));
        }
    }

    /** The heaviest branch while the limit allows. */
    Optional<Branch> next() {
        if (waiting.isEmpty() || followed == MOST_FOLLOWED) {
            return Optional.empty();
        }
        followed++;
        return Optional.of(waiting.remove());
    }

    /** After the last {@link #next}: the weights of all that was not followed, added up. */
    Color weightLeftOut() {
        for (Branch branch : waiting) {
            leftOut.add(1, branch.weight, Color.WHITE);
        }
        waiting.clear();
        return leftOut.total();
    }
}
