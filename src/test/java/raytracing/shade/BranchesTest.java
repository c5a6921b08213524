package raytracing.shade;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import raytracing.SceneText;
import raytracing.compiled.CompiledScene;
import raytracing.compiled.RayWalk;
import raytracing.compiled.ShadowMode;
import raytracing.geometry.Departure;
import raytracing.geometry.Hit;
import raytracing.geometry.HitPoint;
import raytracing.geometry.Ray;
import raytracing.math.Vector;

class BranchesTest {
    private static final Hit HIT = new Hit(3, 0, 1, new Vector(1, 2, 3), 1e-9, new Vector(0, 1, 0), Departure.INWARD);

    private final Branches branches = new Branches();

    private void add(double weight, int reflections) {
        HitPoint from = new HitPoint();
        from.take(HIT);
        Weight green = new Weight();
        green.set(0, weight, 0);
        branches.add(from.place(), 0, 0, 1, green, reflections, 7);
    }

    private double takenWeight() {
        Weight weight = new Weight();
        branches.weigh(weight);
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
            assertTrue(branches.next());
            order[i] = branches.reflections();
        }
        assertEquals("[4, 2, 1, 3]", Arrays.toString(order));
        assertFalse(branches.next());
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
            assertTrue(branches.next());
            assertEquals(heaviest[0], takenWeight());
        }
    }

    @Test
    void aBranchLeavesTheSurfaceOnTheSideFromWhichItWasSeen() {
        add(1, 5);
        branches.next();
        RayWalk walk = new RayWalk(new CompiledScene(
            SceneText.scene("cam 0 0 -5 0 0 0 0 1 0 1 1\nset 0 0 0 1 1"), ShadowMode.ALL_SURFACES_STOP_LIGHT));
        branches.start(walk);
        assertEquals(new Ray(HIT.point(), 1e-9, new Vector(0, 0, 1), 3, Departure.INWARD), walk.ray());
        assertEquals(7, branches.key());
    }

    @Test
    void aNewPixelStartsWithoutBranches() {
        add(1, 1);
        branches.clear();
        assertFalse(branches.next());
        add(0.5, 2);
        assertTrue(branches.next());
        assertEquals(0.5, takenWeight());
    }
}
