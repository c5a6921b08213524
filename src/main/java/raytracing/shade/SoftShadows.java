package raytracing.shade;

import raytracing.compiled.CompiledScene;
import raytracing.compiled.ShadowLine;
import raytracing.compiled.ShadowShaft;
import raytracing.geometry.HitPoint;
import raytracing.math.Vector;
import raytracing.scene.Light;

/**
 * The exercise's soft shadows: a light shines from a square that always faces the shaded point, and N x N shadow rays
 * go to one random point in each of its N x N cells. One thread.
 */
final class SoftShadows {
    private final int root;
    private final ShadowLine[] lines;
    private final ShadowShaft[] shafts;

    /** Shadow rays for a scene; {@code root} is N, at least 1. Each light has its own: they remember what stopped it last. */
    SoftShadows(CompiledScene scene, int root, int lightCount) {
        this.root = root;
        lines = new ShadowLine[lightCount];
        shafts = new ShadowShaft[lightCount];
        for (int i = 0; i < lightCount; i++) {
            lines[i] = new ShadowLine(scene);
            shafts[i] = new ShadowShaft(scene);
        }
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
     * @param key of the random numbers that place the shadow rays in their cells
     * @return in [0, 1]
     */
    double arrivingShare(HitPoint hit, int surface, Light light, int number, double error, long key) {
        double s = light.shadowIntensity();
        if (s == 0) {
            return 1;
        }
        return (1 - s) + s * meanTransmittance(hit, surface, light, number, error, key);
    }

    private double meanTransmittance(HitPoint hit, int surface, Light light, int number, double error, long key) {
        Vector middle = light.position();
        if (root == 1 || light.width() == 0) {
            return lines[number].transmittance(hit, surface, middle.x(), middle.y(), middle.z(), error);
        }
        ShadowShaft shaft = shafts[number];
        shaft.aim(hit, surface, middle.x(), middle.y(), middle.z(), error, light.width());
        double sum = shaft.isSettled() ? sumOfEqual(shaft.settledTransmittance()) : shaft.sumOverCells(root, key);
        return sum / ((double) root * root);
    }

    /** One by one, as the samples of a shadow's border are: so both have the same bits. */
    private double sumOfEqual(double transmittance) {
        if (transmittance == 0 || transmittance == 1) {
            return transmittance * root * root;
        }
        double sum = 0;
        for (int i = 0; i < root * root; i++) {
            sum += transmittance;
        }
        return sum;
    }
}
