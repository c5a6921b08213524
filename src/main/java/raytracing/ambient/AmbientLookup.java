package raytracing.ambient;

import raytracing.color.Color;
import raytracing.color.MutableColor;
import raytracing.hierarchy.PointTraversal;
import raytracing.surface.Hit;

/** Looks up the ambient light at points, without allocation. Not thread-safe. */
public final class AmbientLookup {
    /** With less weight of near records, wide ones are added; a record has weight 1 at its own point. */
    private static final double ENOUGH = 0.2;

    /** Weight of the mean of the whole room among wide records: it is all there is where none of them counts. */
    private static final double WEIGHT_OF_MEAN = 0x1p-10;

    private final AmbientLight ambientLight;
    private final PointTraversal traversal = new PointTraversal();
    private final MutableColor light = new MutableColor();
    private final MutableColor wideLight = new MutableColor();

    public AmbientLookup(AmbientLight ambientLight) {
        this.ambientLight = ambientLight;
    }

    public boolean hasLight() {
        return !ambientLight.isNone();
    }

    /** The light at a point, on the side from which it was seen; overwritten by the next call. */
    public MutableColor at(Hit hit) {
        light.clear();
        if (ambientLight.records().isEmpty()) {
            light.add(1, Color.WHITE, ambientLight.mean());
            return light;
        }
        AmbientLight.Records records = ambientLight.records().get();
        double weight = records.near().addTo(light, hit, traversal);
        if (weight < ENOUGH) {               // add exactly what is missing, so that no border is seen where this begins
            wideLight.clear();
            double wideWeight = records.wide().addTo(wideLight, hit, traversal) + WEIGHT_OF_MEAN;
            wideLight.add(WEIGHT_OF_MEAN, Color.WHITE, ambientLight.mean());
            light.add((ENOUGH - weight) / wideWeight, Color.WHITE, wideLight);
            weight = ENOUGH;
        }
        light.scale(1 / weight);
        return light;
    }
}
