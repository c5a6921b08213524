package raytracing.shade;

import raytracing.compiled.CompiledScene;
import raytracing.geometry.Hit;
import raytracing.geometry.PointError;
import raytracing.math.Basis;
import raytracing.math.CounterRandom;
import raytracing.math.Vector;
import raytracing.scene.Light;

/**
 * The exercise's soft shadows: a light shines from a square that always faces the shaded point, and N x N shadow rays
 * go to one random point in each of its N x N cells. Thread-safe.
 */
final class SoftShadows {
    private final CompiledScene scene;
    private final int root;

    /** Shadow rays for a scene; {@code root} is N, at least 1. */
    SoftShadows(CompiledScene scene, int root) {
        this.scene = scene;
        this.root = root;
    }

    /**
     * The share of a light that arrives, partial shadows included: (1 - s) + s * (mean transmittance towards the
     * square), with s the light's shadow intensity.
     *
     * @param hit the shaded point
     * @param light the light, not at that point
     * @param key of the random numbers that place the shadow rays in their cells
     * @return in [0, 1]
     */
    double arrivingShare(Hit hit, Light light, long key) {
        double s = light.shadowIntensity();
        if (s == 0) {
            return 1;
        }
        return (1 - s) + s * meanTransmittance(hit, light, key);
    }

    private double meanTransmittance(Hit hit, Light light, long key) {
        Vector middle = light.position();
        double error = PointError.written(middle);
        if (root == 1 || light.width() == 0) {
            return scene.transmittance(hit, middle.x(), middle.y(), middle.z(), error);
        }
        Basis square = Basis.around(middle.minus(hit.point()).unit());
        Vector u = square.u();
        Vector v = square.v();
        double cell = light.width() / root;
        double halfRoot = root / 2.0;
        double sum = 0;
        for (int row = 0; row < root; row++) {
            for (int column = 0; column < root; column++) {
                long bits = CounterRandom.bits(key, (long) row * root + column);
                double alongU = (column + CounterRandom.upperFraction(bits) - halfRoot) * cell;
                double alongV = (row + CounterRandom.lowerFraction(bits) - halfRoot) * cell;
                sum += scene.transmittance(hit,
                    middle.x() + (alongU * u.x() + alongV * v.x()),
                    middle.y() + (alongU * u.y() + alongV * v.y()),
                    middle.z() + (alongU * u.z() + alongV * v.z()), error);
            }
        }
        return sum / ((double) root * root);
    }
}
