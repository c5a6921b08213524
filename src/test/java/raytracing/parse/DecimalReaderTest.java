package raytracing.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The oracle for numbers is {@link Double#parseDouble}, bit for bit. */
class DecimalReaderTest {
    private static final int TOKENS = 200_000;

    private static double read(String token) {
        byte[] bytes = token.getBytes(StandardCharsets.UTF_8);
        return new DecimalReader(bytes).read(0, bytes.length);
    }

    /** Compares bits, so that 0 and -0 differ. */
    private static void assertReadAsDouble(String token) {
        assertEquals((Object) Double.parseDouble(token), read(token), token);
    }

    /** Digits with a dot somewhere, and powers of ten on both sides of all bounds of the short way. */
    @Test
    void everyNumberOfDigitsWithEveryUsualPowerIsReadExactly() {
        Random random = new Random(1);
        for (int i = 0; i < TOKENS; i++) {
            StringBuilder digits = new StringBuilder();
            int count = 1 + random.nextInt(20);
            for (int k = 0; k < count; k++) {
                digits.append((char) ('0' + random.nextInt(10)));
            }
            digits.insert(random.nextInt(count + 1), '.');
            assertReadAsDouble((random.nextBoolean() ? "-" : "") + digits);
            assertReadAsDouble(digits + "e" + (random.nextInt(61) - 30));
        }
    }

    @Test
    void whatDoublesAreWrittenAsIsReadBack() {
        Random random = new Random(2);
        for (int i = 0; i < TOKENS; i++) {
            double anyFinite = Double.longBitsToDouble(random.nextLong());
            if (Double.isFinite(anyFinite)) {
                assertEquals((Object) anyFinite, read(Double.toString(anyFinite)));
            }
        }
    }

    /** The middle of two neighbours is the hardest decimal to round; a further digit decides it. */
    @Test
    void middlesOfNeighboursGoToTheEvenOneAndWhatIsBeyondThemToTheNearer() {
        Random random = new Random(3);
        for (int i = 0; i < TOKENS / 10; i++) {
            double low = Math.scalb(1 + random.nextDouble(), random.nextInt(140) - 70);
            double high = Math.nextUp(low);
            String middle = new BigDecimal(low).add(new BigDecimal(high)).divide(BigDecimal.valueOf(2)).toPlainString();
            String beyond = middle + (middle.contains(".") ? "1" : ".1");
            double even = (Double.doubleToRawLongBits(low) & 1) == 0 ? low : high;
            assertEquals(even, read(middle), middle);
            assertEquals(high, read(beyond), beyond);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {
        "9007199254740991", "9007199254740992", "9007199254740993", "9007199254740994", "9007199254740995",
        "9007199254740993e22", "9007199254740991e22", "9007199254740991e23", "9007199254740991e-22",
        "9007199254740991e-23", "3e22", "3e23", "3e-22", "3e-23", "7e23", "7e-23", "90071992547409930e-1", "90071992547409920", "9007199254740992.5",
        "99999999999999999999999999", "18446744073709551617", "0.1", "0.3", "1e308", "1.7976931348623159e308", "1e309",
        "4.9e-324", "2.4e-324", "1e-400", "0e999", "-0", "+0", "-0.0e-99", ".5", "5.", "+5", "00005", "1E5", "1e+5",
        "1e99999999999999999999", "1e-99999999999999999999", "0.0000000000000000000000000000000000001",
        "100000000000000000000000000000000000000", "1.00000000000000000000000000000000000000",
    })
    void numbersAtTheBoundsAreReadExactly(String token) {
        assertReadAsDouble(token);
    }

    @ParameterizedTest
    @ValueSource(strings = {
        "", "+", "-", ".", "+.", "e5", ".e5", "1e", "1e+", "1e5.", "1.2.3", "--1", "+-1", "1-", "1 ", "1d",
        "0x1", "NaN", "Infinity", "1,5", "1_000", "\u0665", "1\u0665", "1e\u0665",
    })
    void whatIsNoDecimalIsNoNumber(String token) {
        assertEquals(Double.NaN, read(token), token);
    }

    @Test
    void onlyTheGivenBytesAreRead() {
        DecimalReader reader = new DecimalReader("91.5e29".getBytes(StandardCharsets.US_ASCII));
        assertEquals(1.5e2, reader.read(1, 6));
        assertEquals(1.5, reader.read(1, 4));
        assertEquals(1, reader.read(1, 2));
        assertEquals(Double.NaN, reader.read(1, 5));
    }
}
