package raytracing.report;

import java.util.List;

/**
 * How much time a scene may take.
 *
 * @param size width and height of its pictures in pixels
 * @param leastRounds so often is each setting drawn at least
 * @param mostRounds and so often at most
 * @param secondsOfRounds no round begins after so long, if there have been enough
 * @param finestShadowRoot N of the halves of the reference for shadows
 * @param eyeRoots n of the n x n rays of a pixel that are measured
 * @param finestEyeRoot n of the first half of the reference for edges; the second has one less
 * @param processes runs of each cold process
 */
record Budget(int size, int leastRounds, int mostRounds, double secondsOfRounds, int finestShadowRoot,
              List<Integer> eyeRoots, int finestEyeRoot, int processes) {
    /** For each of many scenes. */
    static final Budget OF_MANY = new Budget(80, 3, 25, 0.8, 64, List.of(2, 3, 4, 6, 8), 16, 3);

    /** For a single scene. */
    static final Budget OF_ONE = new Budget(200, 5, 25, 20, 96, List.of(2, 3, 4, 5, 6, 7, 8), 24, 7);

    Budget withSize(int newSize) {
        return new Budget(newSize, leastRounds, mostRounds, secondsOfRounds, finestShadowRoot, eyeRoots, finestEyeRoot,
            processes);
    }
}
