package raytracing.shade;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import raytracing.color.Color;
import raytracing.geometry.Ray;
import raytracing.math.Vector;

class BranchesTest {
    private static final Ray RAY = new Ray(Vector.ZERO, new Vector(0, 0, 1));

    private final Branches branches = new Branches();

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
        assertEquals("[4, 2, 1, 3]", Arrays.toString(order));
        assertEquals(Optional.empty(), branches.next());
        assertEquals(Optional.empty(), branches.nextLeftOut());
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
        for (int weight = 3; weight >= 1; weight--) {
            assertEquals(weight, branches.nextLeftOut().orElseThrow().weight().green());
        }
        assertEquals(Optional.empty(), branches.nextLeftOut());
    }
}
