package raytracing.shade;

import raytracing.compiled.CompiledScene;
import raytracing.compiled.ShadowShaft;
import raytracing.geometry.HitPoint;
import raytracing.math.Vector;
import raytracing.scene.Light;

/**
 * The exercise's soft shadows: N x N shadow rays go to one random point in each of the N x N cells of a light's square.
 */
final class SampledShadows extends SoftShadows {
    private final int root;
    private final ShadowShaft[] shafts;

    /** Shadow rays for a scene; {@code root} is N, at least 1. */
    SampledShadows(CompiledScene scene, int root, int lightCount) {
        super(scene, lightCount);
        this.root = root;
        shafts = new ShadowShaft[lightCount];
        for (int i = 0; i < lightCount; i++) {
            shafts[i] = new ShadowShaft(scene, ShadowShaft.Use.LINES);
        }
    }

    @Override
    double meanTransmittance(HitPoint hit, Light light, int number, double error, long key) {
        if (root == 1 || light.width() == 0) {
            return transmittanceFromMiddle(hit, light, number, error);
        }
        Vector middle = light.position();
        ShadowShaft shaft = shafts[number];
        shaft.aim(hit, middle.x(), middle.y(), middle.z(), error, light.width());
        if (shaft.isNarrowerThanRounding()) {
            return transmittanceFromMiddle(hit, light, number, error);
        }
        double sum = shaft.isSettled() ? sumOfEqual(settledTransmittance(shaft)) : sumOverCells(shaft, root, key);
        return sum / ((double) root * root);
    }

    @Override
    void forgetPast() {
        for (ShadowShaft shaft : shafts) {
            shaft.forgetLast();
        }
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
