package raytracing.shadow;

import java.util.OptionalInt;
import raytracing.trace.PreparedScene;

/** How the share of a wide light is found that arrives at a point. */
public sealed interface ShadowMethod {
    /** The exercise's way, with the scene's own N. */
    ShadowMethod OF_THE_SCENE = new Sampled(OptionalInt.empty());

    /** The shadows of a scene whose settings name a shadow ray root. */
    SoftShadows shadows(PreparedScene scene, int rootOfTheScene, int lightCount);

    /**
     * The exercise's way: N x N shadow rays, each to a random point of its cell of the light's square.
     *
     * @param root N, at least 1; of none, the scene's
     */
    record Sampled(OptionalInt root) implements ShadowMethod {
        /** With this N, at least 1, whatever the scene says. */
        public static Sampled withRoot(int root) {
            return new Sampled(OptionalInt.of(root));
        }

        @Override
        public SoftShadows shadows(PreparedScene scene, int rootOfTheScene, int lightCount) {
            return new SampledShadows(scene, root.orElse(rootOfTheScene), lightCount);
        }
    }

    /** What the exercise's way comes to as N grows without bound: the area of the light's square that is seen. */
    record Exact() implements ShadowMethod {
        @Override
        public SoftShadows shadows(PreparedScene scene, int rootOfTheScene, int lightCount) {
            return new ExactShadows(scene, lightCount);
        }
    }
}
