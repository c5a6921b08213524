package raytracing.parallel;

/**
 * How far a picture is before its first pixel is drawn. Thread-safe: the threads that prepare the picture report now and then,
 * and any thread may read the state. Not final, so that a test can count the reports.
 */
public class Preparation {
    private Step step = Step.READING;
    private long expected;
    private long done;

    /** What is done before the drawing, in this order. */
    public enum Step {
        /** The scene's file is read. */
        READING,

        /** The surfaces are put in lists and hierarchies. */
        ARRANGING,

        /** The ambient light is estimated. */
        AMBIENT_LIGHT
    }

    /** How far the preparation is: the share of the step is from 0 to 1, and 0 as long as nothing is known. */
    public record State(Step step, double share) {
    }

    /** Goes on to another step, of which nothing is known yet. */
    public synchronized void begin(Step next) {
        step = next;
        expected = 0;
        done = 0;
    }

    /** Sets how much there is to do in this step: bytes, bodies or cells. */
    public synchronized void expect(long count) {
        expected = count;
    }

    /** Adds what was done since the last call. */
    public synchronized void advance(long count) {
        done += count;
    }

    public synchronized State state() {
        return new State(step, expected == 0 ? 0 : Math.min(1, (double) done / expected));
    }
}
