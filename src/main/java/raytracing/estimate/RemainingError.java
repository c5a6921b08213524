package raytracing.estimate;

import java.util.List;
import raytracing.ambient.IrradianceCache;
import raytracing.color.Color;
import raytracing.color.MutableColor;
import raytracing.hierarchy.PointTraversal;

/**
 * How far a picture is from one with the true ambient light, as gather points tell by themselves: each is left out, and the
 * light that the others' records give its place is compared with its own paths (cross-validation). The product of the
 * differences from both halves of its paths has the square of the others' error as its mean, without the noise of the
 * point's own paths.
 */
final class RemainingError {
    private static final double STEPS = 255;
    private static final int CHANNELS = 3;

    /** With less weight of others, it is not known what a point that stands alone would be without its own light. */
    private static final double LEAST_WEIGHT = 0x1p-6;

    private RemainingError() {
    }

    /**
     * The root of the mean square error in steps of 1/255 of what the picture shows.
     *
     * @param cache of the records of all points
     * @param detail of their radii
     * @param filled share of the picture in which there are points
     */
    static double steps(List<GatherPoint> points, IrradianceCache cache, double detail, double filled) {
        PointTraversal traversal = new PointTraversal();
        MutableColor others = new MutableColor();
        double squares = 0;
        double areas = 0;
        for (GatherPoint point : points) {
            others.clear();
            double weights = cache.addTo(others, point.hit, traversal);
            double area = point.area(detail) / weights;
            areas += area;
            if (weights > 1 + LEAST_WEIGHT) {                // the point's own record has weight 1
                squares += area * square(point, others, weights - 1);
            }
        }
        return STEPS * Math.sqrt(Math.max(0, filled * squares / (CHANNELS * areas)));
    }

    /** The sum over the channels of the square of the others' error at a point, but for chance. */
    private static double square(GatherPoint point, MutableColor all, double weightOfOthers) {
        Color own = point.light();
        Color even = point.lightOfEvenPaths();
        Color odd = point.lightOfOddPaths();
        MutableColor without = point.shownWithout;
        MutableColor share = point.shownOfAmbient;
        return square(without.red(), share.red(), (all.red() - own.red()) / weightOfOthers, even.red(), odd.red())
            + square(without.green(), share.green(), (all.green() - own.green()) / weightOfOthers, even.green(), odd.green())
            + square(without.blue(), share.blue(), (all.blue() - own.blue()) / weightOfOthers, even.blue(), odd.blue());
    }

    /** In one channel, which shows no more than 1. */
    private static double square(double without, double share, double others, double even, double odd) {
        double shown = shown(without + share * others);
        return (shown - shown(without + share * even)) * (shown - shown(without + share * odd));
    }

    private static double shown(double light) {
        return Math.min(1, light);
    }
}
