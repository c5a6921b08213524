package raytracing.shade;

import java.util.List;
import raytracing.color.Color;
import raytracing.compiled.BallTree;
import raytracing.compiled.BallWalk;
import raytracing.geometry.HitPoint;

/**
 * Light gathered at some places, from which that at others is interpolated: an irradiance cache (Ward, Rubinstein, Clear,
 * A Ray Tracing Solution for Diffuse Interreflection, SIGGRAPH 1988). Each record counts within a radius around its place
 * and for surfaces turned by less than 45 degrees, ever less towards these limits, so that no record's end is seen.
 * Immutable.
 */
final class IrradianceCache {
    private static final int STRIDE = 10;
    private static final int NORMAL = 3;
    private static final int LIGHT = 6;
    private static final int PER_RADIUS = 9;

    /** One over 1 - cos 45: turned so far, a record counts no more. */
    private static final double PER_TURN = 1 / (1 - Math.sqrt(0.5));

    private final double[] records;
    private final BallTree tree;

    private IrradianceCache(double[] records, BallTree tree) {
        this.records = records;
        this.tree = tree;
    }

    /** How far from its place a record counts. */
    enum Reach {
        /** As far as it is that of others too. */
        NEAR {
            @Override
            double of(Place place) {
                return place.radius();
            }
        },

        /** As far as it is better than nothing. */
        WIDE {
            @Override
            double of(Place place) {
                return place.wideRadius();
            }
        };

        abstract double of(Place place);
    }

    /**
     * A cache of what was gathered.
     *
     * @param places at least one
     * @param reach of their records
     * @param further what arrives by further bounces than their own, where these end
     */
    static IrradianceCache of(List<Place> places, Reach reach, Color further) {
        double[] balls = new double[BallTree.STRIDE * places.size()];
        for (int i = 0; i < places.size(); i++) {
            HitPoint point = places.get(i).point();
            int at = BallTree.STRIDE * i;
            balls[at] = point.x();
            balls[at + 1] = point.y();
            balls[at + 2] = point.z();
            balls[at + BallTree.RADIUS] = reach.of(places.get(i));
        }
        BallTree tree = new BallTree(balls);
        double[] records = new double[STRIDE * places.size()];
        int at = 0;
        for (int i : tree.order()) {
            write(records, at, places.get(i), further);
            records[at + PER_RADIUS] = 1 / balls[BallTree.STRIDE * i + BallTree.RADIUS];
            at += STRIDE;
        }
        return new IrradianceCache(records, tree);
    }

    private static void write(double[] records, int at, Place place, Color further) {
        HitPoint point = place.point();
        Color light = place.allLight(further);
        records[at] = point.x();
        records[at + 1] = point.y();
        records[at + 2] = point.z();
        records[at + NORMAL] = point.normalX();
        records[at + NORMAL + 1] = point.normalY();
        records[at + NORMAL + 2] = point.normalZ();
        records[at + LIGHT] = light.red();
        records[at + LIGHT + 1] = light.green();
        records[at + LIGHT + 2] = light.blue();
    }

    /**
     * Adds up the light of all records that count at a point, each by its weight.
     *
     * @param sum to which it is added
     * @param hit the point
     * @param walk for the search
     * @return sum of the weights
     */
    double addTo(LightSum sum, HitPoint hit, BallWalk walk) {
        double weights = 0;
        double red = 0;
        double green = 0;
        double blue = 0;
        walk.start(tree, hit.x(), hit.y(), hit.z());
        while (walk.nextLeaf()) {
            int end = STRIDE * walk.to();
            for (int i = STRIDE * walk.from(); i < end; i += STRIDE) {
                double weight = weight(i, hit);
                if (weight > 0) {
                    weights += weight;
                    red += weight * records[i + LIGHT];
                    green += weight * records[i + LIGHT + 1];
                    blue += weight * records[i + LIGHT + 2];
                }
            }
        }
        sum.add(red, green, blue);
        return weights;
    }

    /** 1 at its place and for its normal, smoothly to 0. */
    private double weight(int i, HitPoint hit) {
        double perRadius = records[i + PER_RADIUS];
        double x = (hit.x() - records[i]) * perRadius;
        double y = (hit.y() - records[i + 1]) * perRadius;
        double z = (hit.z() - records[i + 2]) * perRadius;
        double within = 1 - (x * x + y * y + z * z);
        if (!(within > 0)) {                 // this way round, also where a radius is no number
            return 0;
        }
        double turn = 1 - hit.alongNormal(records[i + NORMAL], records[i + NORMAL + 1], records[i + NORMAL + 2]);
        double rest = within - turn * PER_TURN;
        return rest > 0 ? rest * rest : 0;
    }
}
