package raytracing.ambient;

import java.util.List;
import raytracing.color.MutableColor;
import raytracing.hierarchy.Bounds;
import raytracing.hierarchy.Hierarchy;
import raytracing.hierarchy.PointTraversal;
import raytracing.math.Vector;
import raytracing.parallel.ForkJoin;
import raytracing.surface.Hit;

/**
 * Interpolates light between records (Ward, Rubinstein, Clear, A Ray Tracing Solution for Diffuse Interreflection, SIGGRAPH
 * 1988). Each record counts within its radius and for surfaces turned by less than 45 degrees, and less and less towards
 * these limits, so that the end of no record is seen. Immutable.
 */
public final class IrradianceCache {
    /** Numbers of a record: its point, then from these places on its normal, its light, and one over its radius. */
    private static final int STRIDE = 10;
    private static final int NORMAL = 3;
    private static final int LIGHT = 6;
    private static final int PER_RADIUS = 9;

    /** One over 1 - cos 45: a record does not count for a surface turned so far. */
    private static final double PER_TURN = 1 / (1 - Math.sqrt(0.5));

    /** Above or below a record's surface, distances count three times: what lies there is another surface. */
    private static final double PER_ABOVE = 8;

    private final double[] numbers;
    private final Hierarchy hierarchy;

    /** Sorts at least one record into a hierarchy. */
    public IrradianceCache(List<IrradianceRecord> records) {
        Bounds bounds = new Bounds(records.size());
        for (int i = 0; i < bounds.size(); i++) {
            Vector point = records.get(i).point();
            bounds.setAround(i, point.x(), point.y(), point.z(), records.get(i).radius());
        }
        hierarchy = Hierarchy.over(bounds, ForkJoin.sequential());
        numbers = new double[STRIDE * records.size()];
        int at = 0;
        for (int i : hierarchy.order()) {
            IrradianceRecord record = records.get(i);
            double[] values = {record.point().x(), record.point().y(), record.point().z(),
                record.normal().x(), record.normal().y(), record.normal().z(),
                record.light().red(), record.light().green(), record.light().blue(), 1 / record.radius()};
            System.arraycopy(values, 0, numbers, at, STRIDE);
            at += STRIDE;
        }
    }

    /** Adds the light of all records that count at a point, each times its weight; returns the sum of the weights. */
    public double addTo(MutableColor sum, Hit hit, PointTraversal traversal) {
        double weights = 0;
        double red = 0;
        double green = 0;
        double blue = 0;
        traversal.start(hierarchy, hit.x(), hit.y(), hit.z());
        while (traversal.nextLeaf()) {
            int end = STRIDE * traversal.to();
            for (int i = STRIDE * traversal.from(); i < end; i += STRIDE) {
                double weight = weight(i, hit);
                if (weight > 0) {
                    weights += weight;
                    red += weight * numbers[i + LIGHT];
                    green += weight * numbers[i + LIGHT + 1];
                    blue += weight * numbers[i + LIGHT + 2];
                }
            }
        }
        sum.add(red, green, blue);
        return weights;
    }

    /** 1 at the record's point and for its normal, from there smoothly down to 0. */
    private double weight(int i, Hit hit) {
        double perRadius = numbers[i + PER_RADIUS];
        double x = (hit.x() - numbers[i]) * perRadius;
        double y = (hit.y() - numbers[i + 1]) * perRadius;
        double z = (hit.z() - numbers[i + 2]) * perRadius;
        double above = x * numbers[i + NORMAL] + y * numbers[i + NORMAL + 1] + z * numbers[i + NORMAL + 2];
        double within = 1 - (x * x + y * y + z * z) - PER_ABOVE * above * above;
        if (!(within > 0)) {                 // true also if a radius is NaN
            return 0;
        }
        double turn = 1 - hit.alongNormal(numbers[i + NORMAL], numbers[i + NORMAL + 1], numbers[i + NORMAL + 2]);
        double rest = within - turn * PER_TURN;
        return rest > 0 ? rest * rest : 0;
    }
}
