package raytracing.estimate;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import raytracing.color.Color;
import raytracing.color.MutableColor;
import raytracing.math.Vector;
import raytracing.surface.Departure;
import raytracing.surface.HitRecord;

/** How far around a gather point its record counts. */
class GatherPointTest {
    private static GatherPoint point(double spacing, double facing, double nearness) {
        HitRecord floor = new HitRecord(0, 0, Vector.ZERO, 0, new Vector(0, 1, 0), Departure.OUTWARD);
        GatherPoint point = new GatherPoint(floor.toHit(), spacing, facing);
        point.begin(nearness, new PathSegments(0), new PathSegments(0));
        return point;
    }

    @Test
    void recordsCountFurtherWhereMoreIsFree() {
        assertEquals(2, point(1, 1, 1 / 3.0).radius(1));
        assertEquals(2.5, point(1, 1, 0.08).radius(1), 1e-15);
        assertEquals(10, point(1, 1, 0).radius(1));
    }

    @Test
    void recordsThatLieFurtherApartCountFurther() {
        assertEquals(10 * 3, point(3, 1, 0).radius(1));
        assertEquals(2 * 3, point(3, 1, 1).radius(1));
    }

    /** Seen at a cosine of a quarter, points lie four times as far apart in one direction: the root of it is 2. */
    @Test
    void recordsCountFurtherOnSurfacesThatTheEyeLooksAlong() {
        GatherPoint slanted = point(1, 0.25, 1);
        assertEquals(4, slanted.radius(1));
        assertEquals(3 * 4 * 4, slanted.wideRadius(1));
    }

    @Test
    void moreDetailMakesAllRadiiSmaller() {
        GatherPoint slanted = point(1, 0.25, 1);
        assertEquals(2, slanted.radius(0.5));
        assertEquals(3 * 4 * 2, slanted.wideRadius(0.5));
        assertEquals(5, point(1, 1, 0).radius(0.5));
    }

    @Test
    void everyOtherPathIsInOneHalf() {
        GatherPoint point = point(1, 1, 0);
        MutableColor light = new MutableColor();
        for (double each : new double[] {1, 2, 3, 6}) {
            light.set(each, 0, 0);
            point.add(light);
        }
        assertEquals(new Color(3, 0, 0), point.light());
        assertEquals(new Color(2, 0, 0), point.lightOfEvenPaths());
        assertEquals(new Color(4, 0, 0), point.lightOfOddPaths());
    }
}
