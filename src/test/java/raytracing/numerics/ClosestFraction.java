package raytracing.numerics;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.RoundingMode;

/**
 * A fraction of doubles next to a number: off by about 2^-105 of it, for numerator and denominator have 53 bits each.
 * From the continued fraction of the number.
 */
record ClosestFraction(double numerator, double denominator) {
    private static final BigInteger LARGEST = BigInteger.TWO.pow(53);

    /** Of a number above 0 and below 2^50. */
    static ClosestFraction to(BigDecimal number) {
        BigInteger p = BigInteger.ONE;
        BigInteger q = BigInteger.ZERO;
        BigInteger previousP = BigInteger.ZERO;
        BigInteger previousQ = BigInteger.ONE;
        BigDecimal rest = number;
        while (true) {
            BigDecimal whole = rest.setScale(0, RoundingMode.FLOOR);
            BigInteger nextP = whole.toBigInteger().multiply(p).add(previousP);
            BigInteger nextQ = whole.toBigInteger().multiply(q).add(previousQ);
            if (nextP.compareTo(LARGEST) > 0 || nextQ.compareTo(LARGEST) > 0) {
                return new ClosestFraction(p.doubleValue(), q.doubleValue());
            }
            previousP = p;
            previousQ = q;
            p = nextP;
            q = nextQ;
            rest = rest.subtract(whole);
            if (rest.signum() == 0) {
                return new ClosestFraction(p.doubleValue(), q.doubleValue());
            }
            rest = BigDecimal.ONE.divide(rest, ExactChord.DIGITS);
        }
    }
}
