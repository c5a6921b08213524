package raytracing.parse;

import java.nio.charset.StandardCharsets;

/**
 * Reads decimal numbers from bytes: sign, digits with at most one dot, exponent; no words, no hexadecimal, no type suffix.
 * The result is the double nearest to the decimal, as {@link Double#parseDouble} returns it.
 *
 * <p>Most numbers in scenes are short: their digits make a whole number that is a double, and the power of ten that
 * belongs to it is one too, both exactly. Then one multiplication or division of the two rounds once, so it gives the
 * nearest double (William D. Clinger, How to Read Floating Point Numbers Accurately, Proceedings of PLDI 1990). All
 * other numbers are left to {@code parseDouble}.
 */
final class DecimalReader {
    /** Every whole number up to here is a double. */
    private static final long LARGEST_EXACT = 1L << 53;

    /** All whole powers of ten that are doubles: 5^22 has 52 bits, 5^23 has 54. */
    private static final double[] POWERS_OF_TEN = {
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11,
        1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

    private final byte[] text;
    private int position;
    private int end;
    private long significand;
    private long powerOfTen;

    DecimalReader(byte[] text) {
        this.text = text;
    }

    /** Whether a word is a decimal number, perhaps one too large for a double. */
    static boolean isDecimal(String word) {
        byte[] bytes = word.getBytes(StandardCharsets.UTF_8);
        return !Double.isNaN(new DecimalReader(bytes).read(0, bytes.length));
    }

    /** The number in the bytes from {@code from} to before {@code to}: infinite if too large, NaN if there is none. */
    double read(int from, int to) {
        position = from;
        end = to;
        boolean negative = skipSign();
        if (!readDigits() || !readExponent() || position < end) {
            return Double.NaN;
        }
        if (significand > LARGEST_EXACT || Math.abs(powerOfTen) >= POWERS_OF_TEN.length) {
            return Double.parseDouble(new String(text, from, to - from, StandardCharsets.US_ASCII));
        }
        double size = powerOfTen < 0
            ? significand / POWERS_OF_TEN[(int) -powerOfTen] : significand * POWERS_OF_TEN[(int) powerOfTen];
        return negative ? -size : size;
    }

    /** Reads digits and dot as a whole number times a power of ten; false if there is no digit. */
    private boolean readDigits() {
        int start = position;
        significand = wholeNumber(0);
        boolean hasWholePart = position > start;
        powerOfTen = 0;
        if (skip('.')) {
            start = position;
            significand = wholeNumber(significand);
            powerOfTen = start - position;
        }
        return hasWholePart || powerOfTen < 0;
    }

    /** Reads an exponent if there is one; false if it has no digit. */
    private boolean readExponent() {
        if (!skip('e') && !skip('E')) {
            return true;
        }
        boolean negative = skipSign();
        int start = position;
        long exponent = wholeNumber(0);
        powerOfTen += negative ? -exponent : exponent;
        return position > start;
    }

    /** Reads digits after those of {@code before}; a number that is too large to be exact does not grow any further. */
    private long wholeNumber(long before) {
        long number = before;
        int i = position;
        while (i < end && text[i] >= '0' && text[i] <= '9') {
            if (number <= LARGEST_EXACT) {
                number = 10 * number + (text[i] - '0');
            }
            i++;
        }
        position = i;
        return number;
    }

    /** Skips a sign if there is one; returns whether it is a minus. */
    private boolean skipSign() {
        boolean negative = skip('-');
        if (!negative) {
            skip('+');
        }
        return negative;
    }

    private boolean skip(char c) {
        boolean isHere = position < end && text[position] == c;
        if (isHere) {
            position++;
        }
        return isHere;
    }
}
