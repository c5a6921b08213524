package raytracing.shade;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import raytracing.color.MutableColor;
import raytracing.math.UnitVector;
import raytracing.math.Vector;
import raytracing.surface.Departure;
import raytracing.surface.HitRecord;
import raytracing.surface.RayRecord;

class MirroredRayQueueTest {
    private static final HitRecord HIT = new HitRecord(3, 0, new Vector(1, 2, 3), 1e-9, new Vector(0, 1, 0), Departure.INWARD);

    private final MirroredRayQueue queue = new MirroredRayQueue();

    private void add(double weight, int reflections) {
        UnitVector direction = new UnitVector();
        direction.set(0, 0, 1);
        MutableColor green = new MutableColor();
        green.set(0, weight, 0);
        queue.add(HIT.toHit().origin(), direction, green, reflections, 7);
    }

    private double takenWeight() {
        MutableColor weight = queue.remove().weight;
        assertEquals(0, weight.red());
        assertEquals(0, weight.blue());
        return weight.green();
    }

    @Test
    void theHeaviestIsFollowedFirstAndOfEqualOnesTheOldest() {
        add(0.5, 1);
        add(0.75, 2);
        add(0.5, 3);
        add(2, 4);
        int[] order = new int[4];
        for (int i = 0; i < 4; i++) {
            order[i] = queue.remove().reflections;
        }
        assertEquals("[4, 2, 1, 3]", Arrays.toString(order));
        assertTrue(queue.isEmpty());
    }

    /** The law of every queue of this kind, with additions and removals mixed: against a list that is searched. */
    @Test
    void theHeapAlwaysGivesTheHeaviestOfThoseThatWait() {
        SplittableRandom random = new SplittableRandom(4);
        List<double[]> waiting = new ArrayList<>();      // weight and age
        for (int i = 0; i < 1000; i++) {
            for (int added = random.nextInt(3); added >= 0; added--) {
                double weight = random.nextInt(50);
                waiting.add(new double[] {weight, waiting.size() + 3 * i});
                add(weight, 1);
            }
            double[] heaviest = waiting.stream()
                .max(Comparator.<double[]>comparingDouble(ray -> ray[0])).orElseThrow();
            waiting.remove(heaviest);
            assertEquals(heaviest[0], takenWeight());
        }
    }

    @Test
    void aRayLeavesTheSurfaceOnTheSideFromWhichItWasSeen() {
        add(1, 5);
        MirroredRayQueue.MirroredRay mirrored = queue.remove();
        assertEquals(new RayRecord(HIT.point(), 1e-9, new Vector(0, 0, 1), 3, Departure.INWARD), RayRecord.of(mirrored.ray));
        assertEquals(7, mirrored.key);
    }

    @Test
    void aNewPixelStartsWithoutRays() {
        add(1, 1);
        queue.clear();
        assertTrue(queue.isEmpty());
        add(0.5, 2);
        assertEquals(0.5, takenWeight());
    }
}
