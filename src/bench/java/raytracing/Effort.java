package raytracing;

/** How much time a measurement may take. */
enum Effort {
    FULL(7, 7, 10_000_000_000L, 3_000_000_000L), QUICK(3, 3, 2_000_000_000L, 500_000_000L);

    private static final double NANOSECONDS = 1e9;

    private final int pairs;
    private final int frames;
    private final long warmUpNanoseconds;
    private final long measuredNanoseconds;

    Effort(int pairs, int frames, long warmUpNanoseconds, long measuredNanoseconds) {
        this.pairs = pairs;
        this.frames = frames;
        this.warmUpNanoseconds = warmUpNanoseconds;
        this.measuredNanoseconds = measuredNanoseconds;
    }

    /** Of processes, ours and the peer's in turn. */
    int pairs() {
        return pairs;
    }

    /** So many builds of a scene that is warm, and at least so many frames. */
    int frames() {
        return frames;
    }

    /** At least so long does a scene warm up. */
    long warmUpNanoseconds() {
        return warmUpNanoseconds;
    }

    /** At least so long do its frames take together. */
    long measuredNanoseconds() {
        return measuredNanoseconds;
    }

    /** What the warm-up and the frames are, in words. */
    String warmWords() {
        return "At least " + frames + " frames and " + measuredNanoseconds / NANOSECONDS
            + " s of them, after one frame and " + warmUpNanoseconds / NANOSECONDS + " s";
    }
}
