package raytracing.shade;

import raytracing.compiled.CompiledScene;
import raytracing.compiled.ShadowLine;
import raytracing.compiled.ShadowShaft;
import raytracing.geometry.HitPoint;
import raytracing.math.Vector;
import raytracing.scene.Light;

/**
 * How much of a light arrives at a point. A light shines from a square that always faces the point; the shadow is soft
 * where only a part of the square is seen. One thread.
 */
abstract class SoftShadows {
    private final ShadowLine[] lines;
    private long asked;
    private long settled;
    private long rays;
    private long areas;

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
     * @param light the light, not at that point
     * @param number of the light, counted from 0
     * @param error how far each part of its position may be off
     * @param key of the random numbers, if there is need for some
     * @return in [0, 1]
     */
    final double arrivingShare(HitPoint hit, Light light, int number, double error, long key) {
        double s = light.shadowIntensity();
        asked++;
        if (s == 0) {
            settled++;
            return 1;
        }
        return (1 - s) + s * meanTransmittance(hit, light, number, error, key);
    }

    /** Mean over the light's square of what comes through to the hit, in [0, 1]. */
    abstract double meanTransmittance(HitPoint hit, Light light, int number, double error, long key);

    /** Forgets what was asked before, as far as it decides which answers need no ray. */
    void forgetPast() {
    }

    /** What comes through from the middle of a light: a hard shadow. */
    final double transmittanceFromMiddle(HitPoint hit, Light light, int number, double error) {
        Vector middle = light.position();
        rays++;
        return lines[number].transmittance(hit, middle.x(), middle.y(), middle.z(), error);
    }

    /** What comes through a light's shaft along any line, where that is known beforehand. */
    final double settledTransmittance(ShadowShaft shaft) {
        settled++;
        return shaft.settledTransmittance();
    }

    /** Sums what comes through along one line to each of root x root cells of a light's square. */
    final double sumOverCells(ShadowShaft shaft, int root, long key) {
        rays += (long) root * root;
        return shaft.sumOverCells(root, key);
    }

    /** One more shadow is found by areas. */
    final void countArea() {
        areas++;
    }

    /** How often the share of a light was asked for. */
    final long asked() {
        return asked;
    }

    /** How often no ray was needed for the answer. */
    final long settled() {
        return settled;
    }

    /** Lines along which surfaces were asked for. */
    final long rays() {
        return rays;
    }

    /** How often the answer was found by areas. */
    final long areas() {
        return areas;
    }
}
