package raytracing.shade;

import raytracing.compiled.CompiledScene;
import raytracing.compiled.ShadowLine;
import raytracing.compiled.ShadowShaft;
import raytracing.geometry.HitPoint;
import raytracing.geometry.PointError;
import raytracing.math.CounterRandom;
import raytracing.math.Vector;
import raytracing.scene.Light;

/**
 * The exercise's soft shadows: a light shines from a square that always faces the shaded point, and N x N shadow rays
 * go to one random point in each of its N x N cells. One thread.
 */
final class SoftShadows {
    private final int root;
    private final ShadowLine line;
    private final ShadowShaft shaft;

    /** Shadow rays for a scene; {@code root} is N, at least 1. */
    SoftShadows(CompiledScene scene, int root) {
        this.root = root;
        line = new ShadowLine(scene);
        shaft = new ShadowShaft(scene);
    }

    /**
     * The share of a light that arrives, partial shadows included: (1 - s) + s * (mean transmittance towards the
     * square), with s the light's shadow intensity.
     *
     * @param hit the shaded point
     * @param surface number of the surface it is on
     * @param light the light, not at that point
     * @param key of the random numbers that place the shadow rays in their cells
     * @return in [0, 1]
     */
    double arrivingShare(HitPoint hit, int surface, Light light, long key) {
        double s = light.shadowIntensity();
        if (s == 0) {
            return 1;
        }
        return (1 - s) + s * meanTransmittance(hit, surface, light, key);
    }

    private double meanTransmittance(HitPoint hit, int surface, Light light, long key) {
        Vector middle = light.position();
        double error = PointError.written(middle);
        if (root == 1 || light.width() == 0) {
            return line.transmittance(hit, surface, middle.x(), middle.y(), middle.z(), error);
        }
        shaft.aim(hit, surface, middle.x(), middle.y(), middle.z(), error, light.width());
        double sum = shaft.isSettled() ? sumOfEqual(shaft.settledTransmittance()) : sum(light.width() / root, key);
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

    private double sum(double cell, long key) {
        double halfRoot = root / 2.0;
        double sum = 0;
        for (int row = 0; row < root; row++) {
            for (int column = 0; column < root; column++) {
                long bits = CounterRandom.bits(key, (long) row * root + column);
                double alongU = (column + CounterRandom.upperFraction(bits) - halfRoot) * cell;
                double alongV = (row + CounterRandom.lowerFraction(bits) - halfRoot) * cell;
                sum += shaft.transmittance(alongU, alongV);
            }
        }
        return sum;
    }
}
