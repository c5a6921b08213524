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
}
