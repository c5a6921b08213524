package raytracing.shade;

import raytracing.color.Color;
import raytracing.compiled.BallWalk;
import raytracing.geometry.HitPoint;

/** Asks for the ambient light at points. One thread, point after point, without garbage. */
final class AmbientLookup {
    /** With less weight of the places around, those further away are asked as well: a record counts 1 at its own place. */
    private static final double ENOUGH = 0.2;

    /** Weight of the mean of the whole room, which stands for places where there are none. */
    private static final double WEIGHT_OF_MEAN = 0x1p-10;

    private final AmbientLight ambientLight;
    private final BallWalk walk = new BallWalk();
    private final LightSum light = new LightSum();
    private final LightSum wideLight = new LightSum();

    AmbientLookup(AmbientLight ambientLight) {
        this.ambientLight = ambientLight;
    }

    /** Whether there is any. */
    boolean isWanted() {
        return !ambientLight.isNone();
    }

    /** The light at a point, on the side from which it was seen; overwritten by the next. */
    LightSum at(HitPoint hit) {
        light.clear();
        if (ambientLight.places().isEmpty()) {
            light.add(1, Color.WHITE, ambientLight.mean());
            return light;
        }
        AmbientLight.Places places = ambientLight.places().get();
        double weight = places.near().addTo(light, hit, walk);
        if (weight < ENOUGH) {
            addWide(places.wide(), hit, ENOUGH - weight);
            weight = ENOUGH;
        }
        light.scale(1 / weight);
        return light;
    }

    /** Fills up what is missing of the weight, so that no border is seen where it begins to be missing. */
    private void addWide(IrradianceCache wide, HitPoint hit, double missing) {
        wideLight.clear();
        double weight = wide.addTo(wideLight, hit, walk) + WEIGHT_OF_MEAN;
        wideLight.add(WEIGHT_OF_MEAN, Color.WHITE, ambientLight.mean());
        light.add(missing / weight, Color.WHITE, wideLight);
    }
}
