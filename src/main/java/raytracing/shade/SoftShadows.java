package raytracing.shade;

import raytracing.compiled.CompiledScene;
import raytracing.compiled.ShadowLine;
import raytracing.geometry.HitPoint;
import raytracing.math.Vector;
import raytracing.scene.Light;

/**
 * How much of a light arrives at a point. A light shines from a square that always faces the point; the shadow is soft
 * where only a part of the square is seen. One thread.
 */
abstract class SoftShadows {
    private final ShadowLine[] lines;

    /** Each light has its own lines: they remember what stopped them last. */
    SoftShadows(CompiledScene scene, int lightCount) {
        lines = new ShadowLine[lightCount];
        for (int i = 0; i < lightCount; i++) {
            lines[i] = new ShadowLine(scene);
        }
    }

    /** The shadows of a scene whose settings name a shadow ray root. */
    static SoftShadows of(CompiledScene scene, ShadowMethod method, int rootOfTheScene, int lightCount) {
        return method instanceof ShadowMethod.Sampled sampled
            ? new SampledShadows(scene, sampled.root().orElse(rootOfTheScene), lightCount)
            : new ExactShadows(scene, lightCount);
    }

    /**
     * The share of a light that arrives, partial shadows included: (1 - s) + s * (mean transmittance towards the
     * square), with s the light's shadow intensity.
     *
     * @param hit the shaded point
     * @param surface number of the surface it is on
     * @param light the light, not at that point
     * @param number of the light, counted from 0
     * @param error how far each part of its position may be off
     * @param key of the random numbers, if there is need for some
     * @return in [0, 1]
     */
    final double arrivingShare(HitPoint hit, int surface, Light light, int number, double error, long key) {
        double s = light.shadowIntensity();
        if (s == 0) {
            return 1;
        }
        return (1 - s) + s * meanTransmittance(hit, surface, light, number, error, key);
    }

    /** Mean over the light's square of what comes through to the hit, in [0, 1]. */
    abstract double meanTransmittance(HitPoint hit, int surface, Light light, int number, double error, long key);

    /** What comes through from the middle of a light: a hard shadow. */
    final double transmittanceFromMiddle(HitPoint hit, int surface, Light light, int number, double error) {
        Vector middle = light.position();
        return lines[number].transmittance(hit, surface, middle.x(), middle.y(), middle.z(), error);
    }
}
