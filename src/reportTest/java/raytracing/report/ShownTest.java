package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import raytracing.Quantiles;

class ShownTest {
    @Test
    void numbersHaveThreeDigitsThatCount() {
        assertEquals("1.23", Shown.number(1.2345));
        assertEquals("12.3", Shown.number(12.345));
        assertEquals("1230", Shown.number(1234.5));
        assertEquals("0.00500", Shown.number(0.005));
        assertEquals("0", Shown.number(0));
    }

    /** What rounds up to another digit keeps no more of them. */
    @Test
    void aNumberJustBelowAPowerOfTenIsRoundedToIt() {
        assertEquals("10.0", Shown.number(9.9999));
        assertEquals("1000", Shown.number(999.9));
    }

    @Test
    void roughNumbersHaveTwoDigitsThatCount() {
        assertEquals("9.5", Shown.rough(9.46));
        assertEquals("7", Shown.rough(7.04));
        assertEquals("120", Shown.rough(123.4));
        assertEquals("0.28", Shown.rough(0.2751));
    }

    @Test
    void errorsAreAlsoInSteps() {
        assertEquals("0.5", Shown.steps(0.5 / 255));
        assertEquals("12", Shown.steps(0.047));
        assertEquals("< 0.001", Shown.steps(1e-6));
        assertEquals("0", Shown.steps(0));
    }

    @Test
    void errorsHaveAPowerOfTenWithoutLeadingNoughts() {
        assertEquals("4.6e-5", Shown.error(0.0000461));
        assertEquals("1.0e-12", Shown.error(1e-12));
        assertEquals("2.0e0", Shown.error(2));
        assertEquals("3.0e1", Shown.error(30));
        assertEquals("0", Shown.error(0));
    }

    @Test
    void whatIsHardlyBelowOneDoesNotLookLikeOne() {
        assertEquals("0.99999", Shown.similarity(0.9999999));
        assertEquals("1", Shown.similarity(1));
    }

    @Test
    void aShareTooSmallToShowIsNotNone() {
        assertEquals("0", Shown.percent(0));
        assertEquals("< 0.1", Shown.percent(0.00001));
        assertEquals("12.5", Shown.percent(0.125));
    }

    @Test
    void durationsHaveTheirUnit() {
        assertEquals("12.0 ms", Shown.duration(12));
        assertEquals("4.50 s", Shown.duration(4500));
        assertEquals("3.00 min", Shown.duration(180_000));
        assertEquals("5.00 h", Shown.duration(18_000_000));
    }

    @Test
    void equalPicturesHaveNoDecibels() {
        assertEquals("equal", Shown.decibels(Double.POSITIVE_INFINITY));
        assertEquals("48.1", Shown.decibels(48.13));
    }

    @Test
    void quartilesStandInBrackets() {
        assertEquals("2.00 (1.00 - 3.00)", Shown.quartiles(new Quantiles(3, 1, 2, 3)));
    }
}
