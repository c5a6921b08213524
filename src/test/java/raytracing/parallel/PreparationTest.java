package raytracing.parallel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import raytracing.parallel.Preparation.State;
import raytracing.parallel.Preparation.Step;

class PreparationTest {
    private final Preparation preparation = new Preparation();

    @Test
    void itBeginsWithReadingAnUnknownShare() {
        assertEquals(new State(Step.READING, 0), preparation.state());
        preparation.advance(5);
        assertEquals(new State(Step.READING, 0), preparation.state());
    }

    @Test
    void theShareIsWhatWasDoneOfWhatIsExpected() {
        preparation.expect(8);
        preparation.advance(1);
        preparation.advance(2);
        assertEquals(new State(Step.READING, 3.0 / 8), preparation.state());
    }

    @Test
    void eachStepBeginsAnew() {
        preparation.expect(8);
        preparation.advance(8);
        preparation.begin(Step.ARRANGING);
        assertEquals(new State(Step.ARRANGING, 0), preparation.state());
        preparation.expect(4);
        assertEquals(new State(Step.ARRANGING, 0), preparation.state());
        preparation.advance(1);
        assertEquals(new State(Step.ARRANGING, 0.25), preparation.state());
    }

    @Test
    void noShareIsAboveOne() {
        preparation.expect(8);
        preparation.advance(9);
        assertEquals(new State(Step.READING, 1), preparation.state());
    }
}
