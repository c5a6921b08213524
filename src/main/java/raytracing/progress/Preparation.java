package raytracing.progress;

/**
 * How far a picture is before its first pixel is drawn. The threads that work on it tell, now and then; any other may ask at
 * any time.
 */
public final class Preparation {
    private Step step = Step.READING;
    private long expected;
    private long done;

    /** What is done before the drawing, in this order. */
    public enum Step {
        /** The scene's file is read. */
        READING,

        /** The surfaces are put in arrays and hierarchies. */
        ARRANGING,

        /** The ambient light is estimated. */
        AMBIENT_LIGHT
    }

    /**
     * How far it is at one moment.
     *
     * @param step at which it is
     * @param share of this step that is done, from 0 to 1; 0 as long as nothing is known
     */
    public record State(Step step, double share) {
    }

    /**
     * Goes on to another step, of which nothing is known yet.
     *
     * @param next the step
     */
    public synchronized void begin(Step next) {
        step = next;
        expected = 0;
        done = 0;
    }

    /**
     * Tells how much there is to do in this step.
     *
     * @param count of bytes, bodies or places
     */
    public synchronized void expect(long count) {
        expected = count;
    }

    /**
     * Tells that some of it is done.
     *
     * @param count of what was done since the last call
     */
    public synchronized void advance(long count) {
        done += count;
    }

    /**
     * How far it is now.
     *
     * @return step and share
     */
    public synchronized State state() {
        return new State(step, expected == 0 ? 0 : Math.min(1, (double) done / expected));
    }
}
