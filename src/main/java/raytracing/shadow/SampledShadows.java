package raytracing.shadow;

import raytracing.trace.PreparedScene;

/**
 * The exercise's soft shadows: N x N shadow rays go to one random point in each of the N x N cells of a light's square.
 */
final class SampledShadows extends SoftShadows {
    private final int root;

    /** Shadow rays for a scene; {@code root} is N, at least 1. */
    SampledShadows(PreparedScene scene, int root, int lightCount) {
        super(scene, new ShaftQuery(scene, ShaftQuery.Use.LINES, root * root, lightCount), lightCount);
        this.root = root;
    }

    /** The exercise's only ray goes to the middle. */
    @Override
    boolean needsShaft() {
        return root > 1;
    }

    /** Summed one by one, as the samples of a shadow's border are: so both have the same bits. */
    @Override
    double meanOfEqual(double transmittance) {
        if (transmittance == 0 || transmittance == 1) {
            return transmittance;
        }
        double sum = 0;
        for (int i = 0; i < root * root; i++) {
            sum += transmittance;
        }
        return sum / ((double) root * root);
    }

    @Override
    double meanTransmittance(ShaftQuery query, long key) {
        return meanOverCells(query, root, key);
    }
}
