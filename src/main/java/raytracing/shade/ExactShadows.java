package raytracing.shade;

import raytracing.compiled.CompiledScene;
import raytracing.compiled.ExactShadow;
import raytracing.compiled.ShadowShaft;
import raytracing.geometry.HitPoint;
import raytracing.math.Vector;
import raytracing.scene.Light;

/**
 * Soft shadows without noise: what the exercise's tend to as N grows without bound. Only behind more than 128 surfaces
 * that each hide some part of one light from one point, shadow rays take over.
 */
final class ExactShadows extends SoftShadows {
    private static final int ROOT_IN_A_CROWD = 16;

    private final ShadowShaft shaft;
    private final ExactShadow shadow;

    ExactShadows(CompiledScene scene, int lightCount) {
        super(scene, lightCount);
        shaft = new ShadowShaft(scene, ShadowShaft.Use.AREAS);
        shadow = new ExactShadow(scene);
    }

    @Override
    double meanTransmittance(HitPoint hit, Light light, int number, double error, long key) {
        if (light.width() == 0) {
            return transmittanceFromMiddle(hit, light, number, error);
        }
        Vector middle = light.position();
        shaft.aim(hit, middle.x(), middle.y(), middle.z(), error, light.width());
        if (shaft.isNarrowerThanRounding()) {
            return transmittanceFromMiddle(hit, light, number, error);
        }
        if (shaft.isSettled()) {
            return settledTransmittance(shaft);
        }
        if (shaft.isSorted()) {
            countArea();
            return shadow.meanTransmittance(shaft);
        }
        return sumOverCells(shaft, ROOT_IN_A_CROWD, key) / (ROOT_IN_A_CROWD * ROOT_IN_A_CROWD);
    }
}
