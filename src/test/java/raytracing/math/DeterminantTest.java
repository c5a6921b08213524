package raytracing.math;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.SplittableRandom;
import java.util.function.Function;
import org.junit.jupiter.api.Test;

/** Determinants against exact arithmetic; in these tests every coordinate has a part too small for its double. */
class DeterminantTest {
    private static final int CASES = 5_000;
    private static final double U = 0x1p-53;

    /** What the error may be where nearly all of the determinant cancels, as a share of the product of the sizes. */
    private static final double CANCELLED = 0x1p-98;

    /** A vector whose coordinates are the sums of two doubles. */
    private record Long(Vector high, Vector low) {
        static Long of(SplittableRandom random, Vector high) {
            return new Long(high, new Vector(low(random, high.x()), low(random, high.y()), low(random, high.z())));
        }

        private static double low(SplittableRandom random, double high) {
            return random.nextInt(8) == 0 ? random.nextInt(-1, 2) * U * high : random.nextDouble(-1, 1) * U * high;
        }

        ExactVector exact() {
            return ExactVector.of(high).plus(BigDecimal.ONE, ExactVector.of(low));
        }
    }

    private static BigDecimal exact(Long a, Long b, Long c) {
        ExactVector u = a.exact();
        ExactVector v = b.exact();
        ExactVector w = c.exact();
        return u.x().multiply(v.y().multiply(w.z()).subtract(v.z().multiply(w.y())))
            .add(u.y().multiply(v.z().multiply(w.x()).subtract(v.x().multiply(w.z()))))
            .add(u.z().multiply(v.x().multiply(w.y()).subtract(v.y().multiply(w.x()))));
    }

    private static double computed(Long a, Long b, Long c) {
        return Determinant.of(a.high.x(), a.high.y(), a.high.z(), a.low.x(), a.low.y(), a.low.z(),
            b.high.x(), b.high.y(), b.high.z(), b.low.x(), b.low.y(), b.low.z(),
            c.high.x(), c.high.y(), c.high.z(), c.low.x(), c.low.y(), c.low.z());
    }

    private static void assertWithinTheBound(long seed, Function<SplittableRandom, Vector[]> vectors) {
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < CASES; i++) {
            Vector[] v = vectors.apply(random);
            Long a = Long.of(random, v[0]);
            Long b = Long.of(random, v[1]);
            Long c = Long.of(random, v[2]);
            BigDecimal exact = exact(a, b, c);
            double error = new BigDecimal(computed(a, b, c)).subtract(exact).abs().doubleValue();
            double size = v[0].largestPart() * v[1].largestPart() * v[2].largestPart();
            assertTrue(error <= U * exact.abs().doubleValue() + CANCELLED * size,
                () -> a + " " + b + " " + c + ": off by " + error + ", which is " + error / size + " of the sizes");
        }
    }

    private static Vector vector(SplittableRandom random) {
        return new Vector(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
    }

    @Test
    void randomVectors() {
        assertWithinTheBound(61, random -> new Vector[] {vector(random), vector(random), vector(random)});
    }

    /** The third is made of the first two, so that of the determinant only roundings are left. */
    @Test
    void vectorsInAPlane() {
        assertWithinTheBound(62, random -> {
            Vector a = vector(random);
            Vector b = vector(random);
            Vector c = Vectors.plus(a.times(random.nextDouble(-1, 1)), random.nextDouble(-1, 1), b);
            return new Vector[] {a, b, Vectors.plus(c, Math.scalb(1, -random.nextInt(20, 110)), vector(random))};
        });
    }

    /** So that the cross product cancels already. */
    @Test
    void vectorsNearlyAlongALine() {
        assertWithinTheBound(63, random -> {
            Vector a = vector(random);
            Vector b = Vectors.plus(a.times(random.nextDouble(-1, 1)), Math.scalb(1, -random.nextInt(1, 60)), vector(random));
            Vector c = Vectors.plus(a.times(random.nextDouble(-1, 1)), Math.scalb(1, -random.nextInt(1, 60)), vector(random));
            return random.nextBoolean() ? new Vector[] {a, b, c} : new Vector[] {vector(random), b, c};
        });
    }

    private static double number(SplittableRandom random, int exponent) {
        return random.nextInt(10) == 0 ? 0 : Math.scalb(random.nextDouble(-1, 1), exponent - random.nextInt(80));
    }

    /** No two numbers need be of a size: 2^80 apart in a vector, 2^400 apart between two. */
    @Test
    void hugeAndSmallNumbers() {
        assertWithinTheBound(64, random -> {
            Vector[] vectors = new Vector[3];
            for (int i = 0; i < vectors.length; i++) {
                int size = random.nextInt(-200, 200);
                vectors[i] = new Vector(number(random, size), number(random, size), number(random, size));
            }
            return vectors;
        });
    }
}
