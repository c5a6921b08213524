package raytracing.shade;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import raytracing.color.Color;
import raytracing.geometry.Ray;
import raytracing.math.Vector;

class BranchesTest {
    private static final Ray RAY = new Ray(Vector.ZERO, new Vector(0, 0, 1));

    private final Branches branches = new Branches(Branches.NEGLIGIBLE_WEIGHT);

    private void add(double weight, int reflections) {
        branches.add(RAY, new Color(0, weight, 0), reflections, 0);
    }

    @Test
    void theHeaviestIsFollowedFirstAndOfEqualOnesTheOldest() {
        add(0.5, 1);
        add(0.75, 2);
        add(0.5, 3);
        add(2, 4);
        int[] order = new int[4];
        for (int i = 0; i < 4; i++) {
            order[i] = branches.next().orElseThrow().reflections();
        }
        assertEquals("[4, 2, 1, 3]", java.util.Arrays.toString(order));
        assertEquals(Optional.empty(), branches.next());
        assertTrue(branches.weightLeftOut().isBlack());
    }

    @Test
    void whatIsNotFollowedIsWhatWeighsLeast() {
        for (int i = 0; i < Branches.MOST_FOLLOWED + 3; i++) {
            add(1 + i, 1);
        }
        int followed = 0;
        while (branches.next().isPresent()) {
            followed++;
        }
        assertEquals(Branches.MOST_FOLLOWED, followed);
        assertEquals(new Color(0, 1 + 2 + 3, 0), branches.weightLeftOut());
    }

    @Test
    void aNegligibleRayIsLeftOutAndItsWeightIsNot() {
        add(Math.nextDown(Branches.NEGLIGIBLE_WEIGHT), 1);
        assertEquals(Optional.empty(), branches.next());
        assertEquals(new Color(0, Math.nextDown(Branches.NEGLIGIBLE_WEIGHT), 0), branches.weightLeftOut());
    }

    @Test
    void aRayJustHeavyEnoughIsFollowed() {
        add(Branches.NEGLIGIBLE_WEIGHT, 1);
        assertTrue(branches.next().isPresent());
    }
}
