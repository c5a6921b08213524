package raytracing.estimate;

import raytracing.color.Color;
import raytracing.color.MutableColor;
import raytracing.shade.VertexReservoir;

/**
 * The light that paths find beyond a gather point's own bounces, and their weights: sums over the paths of one gather
 * point, or of all. Light that bounces further than the paths go is summed as a geometric series, as in the ambient term of
 * progressive radiosity (Cohen, Chen, Wallace, Greenberg, A Progressive Refinement Approach to Fast Radiosity Image
 * Generation, SIGGRAPH 1988). Not thread-safe.
 */
final class FurtherBounces {
    /** Weights of the paths after the last of the own bounces: this light arrives if light of 1 does where they end. */
    final MutableColor onward = new MutableColor();

    /** Light that they found by the further bounces that were followed. */
    final MutableColor light = new MutableColor();

    /** The part of it that was found by the last bounce. */
    final MutableColor lastLight = new MutableColor();

    /** Weights of the paths before the last bounce. */
    final MutableColor arriving = new MutableColor();

    /** Weights of the paths after the last bounce, which are not followed further. */
    final MutableColor beyond = new MutableColor();

    void add(FurtherBounces other) {
        onward.add(1, Color.WHITE, other.onward);
        light.add(1, Color.WHITE, other.light);
        lastLight.add(1, Color.WHITE, other.lastLight);
        arriving.add(1, Color.WHITE, other.arriving);
        beyond.add(1, Color.WHITE, other.beyond);
    }

    /**
     * The mean light that arrives by further bounces where the paths' own light ends: what the bounces that were followed
     * found and what those beyond would find, over the weight of the paths that went on.
     */
    Color mean() {
        return new Color(
            mean(light.red(), lastLight.red(), arriving.red(), beyond.red(), onward.red()),
            mean(light.green(), lastLight.green(), arriving.green(), beyond.green(), onward.green()),
            mean(light.blue(), lastLight.blue(), arriving.blue(), beyond.blue(), onward.blue()));
    }

    private static double mean(double light, double lastLight, double arriving, double beyond, double onward) {
        return ratio(light + beyond * series(lastLight, arriving, beyond), onward);
    }

    /**
     * Light by endless bounces, from one of them: if paths find light b and send on a share r of what arrives where they
     * end, and so do all further ones, together they find b + r b + r r b + ... = b / (1 - r).
     *
     * @param arriving sum of the weights of the paths that found the light
     * @param beyond sum of the weights of what they send on
     */
    static double series(double light, double arriving, double beyond) {
        return ratio(light, Math.max(arriving - beyond, (1 - VertexReservoir.MOST_REFLECTANCE) * arriving));
    }

    /** Finite, so that 0 times it is 0. */
    private static double ratio(double sum, double weight) {
        return weight > 0 ? Math.min(sum / weight, Double.MAX_VALUE) : 0;
    }
}
