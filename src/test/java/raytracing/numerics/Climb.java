package raytracing.numerics;

import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import raytracing.math.Vector;

/**
 * A search for the queries that a formula answers worst. From each start it changes one number or a few at random, from
 * by half down to by a unit in the last place, and keeps a change that does not make the error smaller. All starts
 * climb for a while, the best quarter of them four times as long, and so on: so the few that lead far up get most of
 * the steps.
 *
 * <p>Double-doubles judge each step, as they are quick; every new height is confirmed by exact arithmetic.
 */
public final class Climb {
    private static final int QUERY_NUMBERS = Queries.RAY + Queries.SURFACE;
    private static final int SCALAR = QUERY_NUMBERS - 1;

    /** The share of the starts that goes on to the next round, and how much longer that round is. */
    private static final int QUARTER = 4;

    /** Numbers stay between 2^-60 and 2^60 or 0, where squares of squares are ordinary doubles. */
    private static final int LARGEST_EXPONENT = 60;

    private static final int FRACTION_BITS = 52;

    private final Shape shape;
    private final Formula formula;
    private final Formula judge;
    private final SplittableRandom random;
    private double[] numbers;
    private double height;
    private Summit summit;

    /**
     * The worst that was found.
     *
     * @param ulps error of the formula's answer to it; infinite for a wrong decision
     * @param query the ray and the surface
     */
    public record Summit(double ulps, Query query) {
    }

    private Climb(Shape shape, Formula formula, Query start, SplittableRandom random) {
        this.shape = shape;
        this.formula = formula;
        this.random = random;
        judge = shape.algorithm("DOUBLE_DOUBLE").formula();
        numbers = numbers(start);
        summit = confirmed(start);
        height = summit.ulps;
    }

    /**
     * Climbs from many starts.
     *
     * @param family where the climbs start
     * @param formula whose errors to climb
     * @param seed the same seed climbs alike on every machine
     * @param starts number of starts
     * @param steps of each start in the first round; each further round takes as many in all as the first
     * @return the highest summit
     */
    public static Summit highest(Family family, Formula formula, long seed, int starts, int steps) {
        Queries queries = family.queries(seed, starts * family.recipe().surfacesPerRay());
        List<Climb> climbs = IntStream.range(0, starts)
            .mapToObj(i -> new Climb(family.shape(), formula, queries.get(i * family.recipe().surfacesPerRay()),
                new SplittableRandom(seed + i))).toList();
        int length = steps;
        for (int count = starts; count > 0; count /= QUARTER) {
            climbs = furthest(climbs, count, length);
            length *= QUARTER;
        }
        return climbs.get(0).summit;
    }

    private static List<Climb> furthest(List<Climb> climbs, int count, int steps) {
        Stream<Climb> best = climbs.stream().limit(count);
        return best.toList().parallelStream().peek(climb -> climb.go(steps))
            .sorted(Comparator.comparingDouble((Climb climb) -> climb.summit.ulps).reversed()).toList();
    }

    private void go(int steps) {
        for (int i = 0; i < steps && summit.ulps < ExactAnswer.WRONG_DECISION; i++) {
            step();
        }
    }

    private void step() {
        double[] changed = numbers.clone();
        change(changed);
        if (!isAllowed(changed)) {
            return;
        }
        double error = quickError(changed);
        if (error < height) {
            return;
        }
        if (error > height) {
            Summit higher = confirmed(query(changed));
            if (higher.ulps <= height) {
                return;
            }
            summit = higher;
            height = higher.ulps;
        }
        numbers = changed;
    }

    private void change(double[] n) {
        switch (random.nextInt(12)) {
            case 0 -> swap(n, 3 * random.nextInt(3) + random.nextInt(3), 3 * random.nextInt(3) + random.nextInt(3));
            case 1 -> negate(n, random.nextInt(QUERY_NUMBERS));
            case 2 -> nudgeAll(n);
            default -> {
                for (int i = random.nextInt(1, 4); i > 0; i--) {
                    nudge(n, random.nextInt(QUERY_NUMBERS), random.nextInt(1, FRACTION_BITS + 2));
                }
            }
        }
    }

    private static void swap(double[] n, int i, int j) {
        double number = n[i];
        n[i] = n[j];
        n[j] = number;
    }

    private static void negate(double[] n, int i) {
        if (i != SCALAR) {
            n[i] = -n[i];
        }
    }

    private void nudgeAll(double[] n) {
        int bits = random.nextInt(1, FRACTION_BITS + 2);
        for (int i = 0; i < QUERY_NUMBERS; i++) {
            nudge(n, i, bits);
        }
    }

    /** By less than 2^-bits of the number, and at least by a unit in its last place. */
    private void nudge(double[] n, int i, int bits) {
        double step = Math.scalb(random.nextDouble(-1, 1), -bits) * n[i];
        double nudged = n[i] + step;
        n[i] = nudged != n[i] ? nudged : random.nextBoolean() ? Math.nextUp(n[i]) : Math.nextDown(n[i]);
    }

    private boolean isAllowed(double[] n) {
        for (double number : n) {
            if (number != 0 && Math.abs(Math.getExponent(number)) > LARGEST_EXPONENT) {
                return false;
            }
        }
        boolean hasDirection = n[3] != 0 || n[4] != 0 || n[5] != 0;
        boolean hasSurface = shape == Shape.PLANE ? n[6] != 0 || n[7] != 0 || n[8] != 0 : n[SCALAR] > 0;
        return hasDirection && hasSurface;
    }

    private double quickError(double[] n) {
        Query query = query(n);
        double found = formula.firstCrossing(query);
        double wanted = judge.firstCrossing(query);
        if (found == wanted) {
            return 0;
        }
        return Math.abs(found - wanted) / Math.ulp(Math.min(found, wanted));
    }

    private Summit confirmed(Query query) {
        return new Summit(shape.exactAnswer(query).errorInUlps(formula.firstCrossing(query)), query);
    }

    private static double[] numbers(Query query) {
        Vector o = query.origin();
        Vector d = query.direction();
        Vector v = query.vector();
        return new double[] {o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), v.x(), v.y(), v.z(), query.scalar()};
    }

    private static Query query(double[] n) {
        return Query.of(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9]);
    }
}
