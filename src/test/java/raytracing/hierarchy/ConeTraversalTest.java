package raytracing.hierarchy;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import raytracing.math.Vector;
import raytracing.parallel.ForkJoin;

class ConeTraversalTest {
    private static final int BOXES = 400;

    private static Vector vector(SplittableRandom random, double size) {
        return new Vector(random.nextDouble(-size, size), random.nextDouble(-size, size), random.nextDouble(-size, size));
    }

    /**
     * Random points of a cone lie in boxes: each of these boxes is found. Of all boxes, a tenth at most is found on the
     * mean.
     */
    @Test
    void everyBoxThatHoldsAPointOfTheConeIsFound() {
        SplittableRandom random = new SplittableRandom(1);
        long found = 0;
        long held = 0;
        for (int i = 0; i < 300; i++) {
            double scale = Math.scalb(1, random.nextInt(-60, 60));
            Vector[] middles = new Vector[BOXES];
            double[] halves = new double[BOXES];
            Bounds bounds = new Bounds(BOXES);
            for (int k = 0; k < BOXES; k++) {
                middles[k] = vector(random, 4 * scale);
                halves[k] = random.nextDouble(0.02, 0.5) * scale;
                bounds.setAround(k, middles[k].x(), middles[k].y(), middles[k].z(), halves[k]);
            }
            Hierarchy hierarchy = Hierarchy.over(bounds, ForkJoin.sequential());
            Vector apex = vector(random, 4 * scale);
            Vector axis = vector(random, 1).unit();
            double sine = random.nextDouble(0.001, 0.2);
            double latest = random.nextBoolean() ? Double.POSITIVE_INFINITY : random.nextDouble(1, 5) * scale;
            boolean[] isFound = found(hierarchy, apex, axis, sine, latest);
            for (boolean isOne : isFound) {
                found += isOne ? 1 : 0;
            }
            for (int ray = 0; ray < 300; ray++) {
                Vector direction = near(axis, sine, random);
                double t = Math.min(latest, random.nextDouble(0, 6 * scale));
                for (int k = 0; k < BOXES; k++) {
                    boolean isInside = apex.minus(middles[k]).minus(direction.times(-t)).largestPart() <= halves[k];
                    held += isInside ? 1 : 0;
                    assertTrue(isFound[k] || !isInside, "a box is left out");
                }
            }
        }
        assertTrue(held > 1000, held + " boxes held a point");
        assertTrue(found < 300 * BOXES / 10, found + " boxes found");
    }

    private static boolean[] found(Hierarchy hierarchy, Vector apex, Vector axis, double sine, double latest) {
        ConeTraversal traversal = new ConeTraversal();
        traversal.startCone(hierarchy, apex.x(), apex.y(), apex.z(), axis.x(), axis.y(), axis.z(), sine,
            Math.sqrt(1 - sine * sine), 0, latest);
        boolean[] found = new boolean[BOXES];
        while (traversal.nextLeaf()) {
            for (int i = traversal.from(); i < traversal.to(); i++) {
                found[hierarchy.order()[i]] = true;
            }
        }
        return found;
    }

    /** A direction of the cone, often on its mantle. */
    private static Vector near(Vector axis, double sine, SplittableRandom random) {
        Vector aside = axis.cross(vector(random, 1)).unit();
        double off = sine * (random.nextBoolean() ? 1 : random.nextDouble());
        return axis.times(Math.sqrt(1 - off * off)).minus(aside.times(-off));
    }
}
