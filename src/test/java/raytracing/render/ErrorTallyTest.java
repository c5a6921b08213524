package raytracing.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class ErrorTallyTest {
    private final ErrorTally tally = new ErrorTally();

    @Test
    void theErrorIsTheRootOfTheMeanSquareOfPixelsThatVary() {
        tally.add(4, 3, true);
        tally.add(16, 4, true);
        tally.add(1, 100, false);
        assertEquals(Math.sqrt(12.5), tally.error(), 1e-6);
        assertEquals(4, tally.largest());
    }

    @Test
    void pixelsAreCountedByTheirRays() {
        tally.add(1, 0, false);
        tally.add(1, 0, false);
        tally.add(4, 0, false);
        tally.add(4096, 0, true);
        assertEquals(2, tally.pixelsAt(0));
        assertEquals(1, tally.pixelsAt(1));
        assertEquals(1, tally.pixelsAt(ErrorTally.levels() - 1));
        assertEquals(4096, ErrorTally.rays(ErrorTally.levels() - 1));
        assertEquals(2, tally.refined());
        assertEquals(4100, tally.furtherRays());
    }

    @Test
    void talliesAddUp() {
        ErrorTally other = new ErrorTally();
        other.add(4096, 9, true);
        other.addUnfinished(9);
        tally.add(8, 1, true);
        tally.add(other);
        assertEquals(Math.sqrt(41), tally.error(), 1e-6);
        assertEquals(1, tally.unfinished());
        assertEquals(9, tally.largestUnfinished());
        tally.clear();
        assertEquals(0, tally.error());
        assertEquals(0, tally.refined());
        assertEquals(0, tally.unfinished());
    }
}
