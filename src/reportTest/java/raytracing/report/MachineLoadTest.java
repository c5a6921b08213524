package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

class MachineLoadTest {
    private static String sentences(double before) {
        return new MachineLoad(OptionalDouble.of(before), OptionalDouble.of(2.04), 2).sentences();
    }

    @Test
    void aQuietMachineIsSaidToBeSo() {
        assertEquals("Load of the machine: 0.1 before and 2 after; the measurement alone makes 2.", sentences(0.1));
    }

    @Test
    void aBusyMachineIsAWarning() {
        assertEquals("Load of the machine: 9.3 before and 2 after; the measurement alone makes 2. "
            + "Other programs were running: times are too long, ratios of times less so.", sentences(9.3));
    }

    @Test
    void aSystemThatDoesNotSayIsNotGuessed() {
        assertEquals("The system does not say how busy the machine was.",
            new MachineLoad(OptionalDouble.empty(), OptionalDouble.empty(), 2).sentences());
    }
}
