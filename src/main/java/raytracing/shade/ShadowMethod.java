package raytracing.shade;

import java.util.OptionalInt;

/** How the share of a wide light is found that arrives at a point. */
public sealed interface ShadowMethod {
    /** The exercise's way, with the scene's own N. */
    ShadowMethod OF_THE_SCENE = new Sampled(OptionalInt.empty());

    /**
     * The exercise's way: N x N shadow rays, each to a random point of its cell of the light's square.
     *
     * @param root N, at least 1; of none, the scene's
     */
    record Sampled(OptionalInt root) implements ShadowMethod {
        /**
         * As many shadow rays as one likes.
         *
         * @param root N, at least 1
         * @return this method with that N, whatever the scene says
         */
        public static Sampled withRoot(int root) {
            return new Sampled(OptionalInt.of(root));
        }
    }

    /** What the exercise's way comes to as N grows without bound: the area of the light's square that is seen. */
    record Exact() implements ShadowMethod {
    }
}
