package raytracing.hierarchy;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.parallel.ForkJoin;
import raytracing.parallel.Preparation;

class HierarchyTest {
    /** Groups of every kind that a scene can hold, ordinary and not. */
    static Map<String, double[]> groups() {
        return Map.ofEntries(
            Map.entry("one body", Boxes.scattered(1, 0.1)),
            Map.entry("two bodies", Boxes.scattered(2, 0.1)),
            Map.entry("a body more than a leaf holds", Boxes.concentric(9)),
            Map.entry("small bodies", Boxes.scattered(20_000, 0.01)),
            Map.entry("bodies that overlap", Boxes.scattered(5_000, 0.5)),
            Map.entry("bodies side by side", Boxes.grid(12)),
            Map.entry("coincident bodies", new double[6_000]),
            Map.entry("concentric bodies", Boxes.concentric(100_000)),
            Map.entry("bodies that shrink in a row", shrinking(1_400)),
            Map.entry("bodies whose areas are infinite", Boxes.scaled(Boxes.scattered(1_000, 0.1), 0x1p100)),
            Map.entry("bodies whose areas are 0", Boxes.scaled(Boxes.scattered(1_000, 0.1), 0x1p-100)),
            Map.entry("bodies too large for floats", Boxes.scaled(Boxes.scattered(1_000, 0.1), 0x1p1000)),
            Map.entry("bodies too small for floats", Boxes.scaled(Boxes.scattered(1_000, 0.1), 0x1p-1000)),
            Map.entry("bodies as large as doubles go", full(100)));
    }

    /** Each is half as large as the one before and half as far from 0: the heuristic peels off one after the other. */
    private static double[] shrinking(int n) {
        double[] numbers = new double[Bounds.STRIDE * n];
        for (int i = 0; i < n; i++) {
            Arrays.fill(numbers, Bounds.STRIDE * i, Bounds.STRIDE * i + 3, Math.scalb(1.0, 70 - i));
            Arrays.fill(numbers, Bounds.STRIDE * i + 3, Bounds.STRIDE * i + 6, Math.scalb(1.5, 70 - i));
        }
        return numbers;
    }

    private static double[] full(int n) {
        double[] numbers = new double[Bounds.STRIDE * n];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = i % 6 < 3 ? -Double.MAX_VALUE : Double.MAX_VALUE;
        }
        return numbers;
    }

    static Stream<String> names() {
        return groups().keySet().stream().sorted();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("names")
    void everyBodyHasOnePlaceInTheOrder(String group) {
        Boxes boxes = Boxes.of(groups().get(group));
        int[] sorted = boxes.hierarchy().order().clone();
        Arrays.sort(sorted);
        assertArrayEquals(IntStream.range(0, boxes.size()).toArray(), sorted);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("names")
    void everyPlaceIsInOneLeaf(String group) {
        Boxes boxes = Boxes.of(groups().get(group));
        Hierarchy nodes = boxes.hierarchy();
        int[] leavesAt = new int[boxes.size()];
        int largest = 0;
        for (int node = 0; node < nodes.links().length; node++) {
            int link = nodes.links()[node];
            if (link < 0) {
                for (int i = Nodes.from(link); i < Nodes.to(link); i++) {
                    leavesAt[i]++;
                }
                largest = Math.max(largest, Nodes.to(link) - Nodes.from(link));
            }
        }
        assertTrue(Arrays.stream(leavesAt).allMatch(count -> count == 1));
        assertTrue(largest >= 1 && largest <= 8, () -> "no useful size for a leaf");
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("names")
    void everyBoxIsInsideTheOneAbove(String group) {
        Boxes boxes = Boxes.of(groups().get(group));
        Hierarchy nodes = boxes.hierarchy();
        int[] order = boxes.hierarchy().order();
        int checked = 0;
        for (int node = 0; node < nodes.links().length; node++) {
            int link = nodes.links()[node];
            if (link > 0) {
                assertTrue(isInside(nodes.boxes(), node + link, nodes.boxes(), node));
                assertTrue(isInside(nodes.boxes(), node + link + 1, nodes.boxes(), node));
            }
            for (int i = Nodes.from(link); link < 0 && i < Nodes.to(link); i++) {
                assertTrue(holds(nodes.boxes(), node, boxes, order[i]));
                checked++;
            }
        }
        assertEquals(boxes.size(), checked);
    }

    private static boolean isInside(float[] boxes, int inner, float[] others, int outer) {
        boolean isInside = true;
        for (int axis = 0; axis < 3; axis++) {
            int at = Bounds.STRIDE * inner + axis;
            int other = Bounds.STRIDE * outer + axis;
            isInside &= boxes[at] >= others[other] && boxes[at + Bounds.TO_HIGH] <= others[other + Bounds.TO_HIGH];
        }
        return isInside;
    }

    private static boolean holds(float[] boxes, int node, Boxes bodies, int body) {
        boolean holds = true;
        for (int axis = 0; axis < 3; axis++) {
            int at = Bounds.STRIDE * node + axis;
            holds &= boxes[at] <= bodies.low(body, axis) && boxes[at + Bounds.TO_HIGH] >= bodies.high(body, axis);
        }
        return holds;
    }

    /** As deep as the stacks of the traversals, whose size is fixed. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("names")
    void noLeafIsTooDeep(String group) {
        assertTrue(depth(Boxes.of(groups().get(group)).hierarchy()) <= HierarchyBuilder.GREATEST_DEPTH);
    }

    private static int depth(Hierarchy hierarchy) {
        return depth(hierarchy.links(), Hierarchy.ROOT);
    }

    private static int depth(int[] links, int node) {
        return links[node] < 0 ? 0 : 1 + Math.max(depth(links, node + links[node]), depth(links, node + links[node] + 1));
    }

    /** 12 steps would be perfect for leaves of 4 or 5 bodies. */
    @Test
    void aTreeOverScatteredBodiesIsBalanced() {
        int depth = depth(Boxes.of(Boxes.scattered(20_000, 0.01)).hierarchy());
        assertTrue(depth >= 12 && depth <= 20, () -> "depth " + depth);
    }

    @Test
    void boxesComeOutInTheOrderOfTheHierarchy() {
        Bounds bounds = Boxes.bounds(Boxes.scattered(1_000, 0.1));
        float[] numbers = bounds.numbers().clone();
        int[] order = Hierarchy.over(bounds, ForkJoin.sequential()).order();
        assertFalse(Arrays.equals(numbers, bounds.numbers()), "nothing moved");
        for (int i = 0; i < order.length; i++) {
            assertArrayEquals(Arrays.copyOfRange(numbers, 6 * order[i], 6 * order[i] + 6),
                Arrays.copyOfRange(bounds.numbers(), 6 * i, 6 * i + 6));
        }
    }

    @Test
    void scaleChangesNothingButTheBoxes() {
        double[] numbers = inFloats(Boxes.scattered(5_000, 0.02));
        Boxes ordinary = Boxes.of(numbers);
        for (double factor : new double[] {0x1p-40, 0x1p-10, 0x1p40}) {
            Boxes scaled = Boxes.of(Boxes.scaled(numbers, factor));
            assertArrayEquals(ordinary.hierarchy().order(), scaled.hierarchy().order());
            assertArrayEquals(ordinary.hierarchy().links(), scaled.hierarchy().links());
            float[] boxes = ordinary.hierarchy().boxes().clone();
            for (int i = 0; i < boxes.length; i++) {
                boxes[i] *= (float) factor;
            }
            assertArrayEquals(boxes, scaled.hierarchy().boxes());
        }
    }

    /** Numbers to which rounding outwards does nothing. */
    private static double[] inFloats(double[] numbers) {
        return Arrays.stream(numbers).map(number -> (float) number).toArray();
    }

    /** So many bodies that tasks are forked, and that more than once. */
    @Test
    void theTreeDoesNotDependOnTheNumberOfThreads() {
        double[] numbers = Boxes.scattered(300_000, 0.005);
        Hierarchy expected = Boxes.of(numbers).hierarchy();
        Hierarchy found = Boxes.of(numbers, new ForkJoin(64, new Preparation())).hierarchy();
        assertArrayEquals(expected.order(), found.order());
        assertArrayEquals(expected.links(), found.links());
        assertArrayEquals(expected.boxes(), found.boxes());
    }

    @Test
    void twoCrowdsArePartedBetweenThem() {
        double[] numbers = Boxes.scattered(200, 0.1);
        for (int i = 0; i < 100; i++) {
            numbers[6 * i + 1] += 10;
            numbers[6 * i + 4] += 10;
        }
        Boxes boxes = Boxes.of(numbers);
        float[] found = boxes.hierarchy().boxes();
        int children = boxes.hierarchy().links()[Hierarchy.ROOT];
        assertTrue(found[6 * children + 4] < 2, "the lower crowd");
        assertTrue(found[6 * children + 7] > 9, "the upper crowd");
    }
}
