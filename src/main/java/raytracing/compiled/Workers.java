package raytracing.compiled;

/** Whoever does the work of making a scene ready: one thread, or several. The result is the same. */
public interface Workers {
    /** The calling thread alone, which tells its progress to no user. */
    Workers ALONE = new Workers() {
        @Override
        public void doBoth(Runnable first, Runnable second) {
            first.run();
            second.run();
        }

        @Override
        public void expect(long count) {
            // not shown
        }

        @Override
        public void advance(long count) {
            // not shown
        }
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
    void expect(long count);

    /**
     * Is told that some of it is done. To be called now and then, from any thread.
     *
     * @param count of what was done since the last call
     */
    void advance(long count);
}
