package raytracing.shadow;

import raytracing.math.Vector;
import raytracing.scene.Light;
import raytracing.surface.Hit;
import raytracing.trace.PreparedScene;
import raytracing.trace.SegmentQuery;

/**
 * How much of a light arrives at a hit. A light shines from a square that always faces the hit; the shadow is soft where only
 * a part of the square is seen. Not thread-safe.
 */
public abstract class SoftShadows {
    /** One for all lights, as there may be many: of each light they remember no more than a few numbers. */
    private final SegmentQuery line;
    private final ShaftQuery shaft;
    private long queries;
    private long settled;
    private long rays;
    private long areas;

    SoftShadows(PreparedScene scene, ShaftQuery shaft, int lightCount) {
        line = new SegmentQuery(scene, lightCount);
        this.shaft = shaft;
    }

    /**
     * The share of a light that arrives, partial shadows included: (1 - s) + s * (mean transmittance towards the
     * square), with s the light's shadow intensity.
     *
     * @param light not at the hit
     * @param number of the light, counted from 0
     * @param error how far each coordinate of its position may be off
     * @param key of the random numbers, if there is need for some
     * @return in [0, 1]
     */
    public final double arrivingShare(Hit hit, Light light, int number, double error, long key) {
        double s = light.shadowIntensity();
        queries++;
        if (s == 0) {
            settled++;
            return 1;
        }
        return (1 - s) + s * meanTransmittance(hit, light, number, error, key);
    }

    /** Mean over the light's square of what comes through to the hit, in [0, 1]. */
    private double meanTransmittance(Hit hit, Light light, int number, double error, long key) {
        Vector middle = light.position();
        if (light.width() > 0 && needsShaft()) {
            shaft.aim(hit, number, middle.x(), middle.y(), middle.z(), error, light.width());
            if (!shaft.isNarrowerThanRounding()) {
                if (shaft.isSettled()) {
                    settled++;
                    return meanOfEqual(shaft.settledTransmittance());
                }
                return meanTransmittance(shaft, key);
            }
        }
        rays++;
        return line.transmittance(hit, number, middle.x(), middle.y(), middle.z(), error);
    }

    /** Whether a light's shadows have hard edges: it is a point, or one line leads to its middle. */
    public final boolean isHard(Light light) {
        return light.width() == 0 || !needsShaft();
    }

    /** Whether a light with a width is more than its middle, to which one line leads. */
    boolean needsShaft() {
        return true;
    }

    /** The mean where the same comes through along all lines. */
    double meanOfEqual(double transmittance) {
        return transmittance;
    }

    /** The mean over the square of a shaft in which obstacles are left. */
    abstract double meanTransmittance(ShaftQuery query, long key);

    /** The mean over one line to each of root x root cells of a light's square. */
    final double meanOverCells(ShaftQuery query, int root, long key) {
        rays += (long) root * root;
        return query.sumOverCells(root, key) / ((double) root * root);
    }

    /** One more shadow is found by areas. */
    final void countArea() {
        areas++;
    }

    /** Forgets the queries before, as far as they decide which answers need no ray. */
    public final void forgetPast() {
        shaft.forgetPast();
    }

    /** How often the share of a light was needed. */
    public final long queries() {
        return queries;
    }

    /** How often that took no ray. */
    public final long settled() {
        return settled;
    }

    /** Lines along which surfaces were tested. */
    public final long rays() {
        return rays;
    }

    /** How often the share was found by areas. */
    public final long areas() {
        return areas;
    }
}
