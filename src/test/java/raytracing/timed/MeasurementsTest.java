package raytracing.timed;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

class MeasurementsTest {
    @Test
    void ofManyValuesTheOrderDoesNotCount() {
        assertEquals(Optional.of(new Spread(1, 3, 9)), Spread.of(List.of(9.0, 1.0, 3.0)));
    }

    @Test
    void nothingHasNoSpread() {
        assertEquals(Optional.empty(), Spread.of(List.of()));
    }

    @Test
    void aSpreadIsShownWithTheDecimalsAskedFor() {
        assertEquals("1.25 (0.50 - 2.00)", new Spread(0.5, 1.25, 2).shown(2));
        assertEquals("12 (8 - 20)", new Spread(8, 12, 20).shown(0));
    }

    @Test
    void aProcessPaysForItsOwnTimeAndTheSystems() {
        ProcessCost cost = ProcessCost.of(1.5, "2.25 0.25 2048\n");
        assertEquals(new ProcessCost(1.5, OptionalDouble.of(2.5), OptionalDouble.of(2)), cost);
    }

    @Test
    void theClockAloneKnowsNothingOfProcessorsAndMemory() {
        assertEquals(new ProcessCost(1.5, OptionalDouble.empty(), OptionalDouble.empty()), ProcessCost.of(1.5));
    }
}
