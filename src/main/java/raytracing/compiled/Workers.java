package raytracing.compiled;

/** Whoever does the work of making a scene ready: one thread, or several. The result is the same. */
@FunctionalInterface
public interface Workers {
    /** The calling thread alone. */
    Workers ALONE = (first, second) -> {
        first.run();
        second.run();
    };

    /**
     * Does two pieces of work that do not touch each other, and returns after both. Either may ask for this again.
     *
     * @param first one piece
     * @param second the other, maybe done at the same time
     */
    void doBoth(Runnable first, Runnable second);

    /**
     * Is told how much there is to do, for the user to see how far it is.
     *
     * @param count of bodies or places
     */
    default void expect(long count) {
    }

    /**
     * Is told that some of it is done. To be called now and then, from any thread.
     *
     * @param count of what was done since the last call
     */
    default void advance(long count) {
    }
}
