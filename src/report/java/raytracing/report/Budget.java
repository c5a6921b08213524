package raytracing.report;

import java.util.List;

/**
 * How much time a scene may take.
 *
 * @param size width and height of its pictures in pixels
 * @param leastRounds so often is each setting drawn at least, if it is not slow
 * @param mostRounds and so often at most
 * @param millisecondsOfSlow a setting whose frames, at least two, have taken so long together is slow: it is not drawn again
 * @param secondsOfRounds no round begins after so long, if there have been enough
 * @param roundsAgain so often, at most, are settings drawn again whose times look like noise
 * @param shadowRoots N of the N x N shadow rays that are measured, beside the scene's own
 * @param finestShadowRoot N of the halves of the reference for shadows
 * @param edgeRoots n of the n x n rays at edges that are measured
 * @param everywhereRoots n of the n x n rays in every pixel that are measured
 * @param errorLimits E of the settings with an error limit, in steps
 * @param finestEyeRoot n of the first half of the reference for edges; the second has one less
 * @param blocksPerCompared one of so many blocks of a picture is compared with the reference; 1 for the whole picture
 * @param processes runs of each cold process
 * @param shownEdge pictures on the page are scaled down to so many pixels
 */
record Budget(int size, int leastRounds, int mostRounds, double millisecondsOfSlow, double secondsOfRounds, int roundsAgain,
              List<Integer> shadowRoots, int finestShadowRoot, List<Integer> edgeRoots, List<Integer> everywhereRoots,
              List<Double> errorLimits, int finestEyeRoot, int blocksPerCompared, int processes, int shownEdge) {
    /** The size of picture that the program draws when it is asked for none. */
    private static final int SIZE = 500;

    /** For each of many scenes. */
    static final Budget OF_MANY = new Budget(SIZE, 3, 25, 3000, 0.8, 2, List.of(1, 2, 4, 8, 16), 64, List.of(2, 4, 6, 8),
        List.of(2, 4), List.of(8.0, 4.0, 2.0, 1.0), 12, 8, 3, SIZE / 2);

    /** For a single scene. */
    static final Budget OF_ONE = new Budget(SIZE, 5, 25, 10_000, 20, 4, List.of(1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16), 64,
        List.of(2, 3, 4, 5, 6, 8), List.of(2, 3, 4, 6), List.of(16.0, 8.0, 4.0, 2.0, 1.0, 0.5), 16, 1, 7, SIZE);

    Budget withSize(int newSize) {
        return new Budget(newSize, leastRounds, mostRounds, millisecondsOfSlow, secondsOfRounds, roundsAgain,
            shadowRoots, finestShadowRoot, edgeRoots, everywhereRoots, errorLimits, finestEyeRoot,
            blocksPerCompared, processes, shownEdge);
    }
}
