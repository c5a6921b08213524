package raytracing.estimate;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import raytracing.math.Vector;
import raytracing.surface.Departure;
import raytracing.surface.HitRecord;

/** How far around a gather point its record counts. */
class GatherPointTest {
    private static GatherPoint point(double spacing, double facing, double nearness) {
        HitRecord floor = new HitRecord(0, 0, Vector.ZERO, 0, new Vector(0, 1, 0), Departure.OUTWARD);
        GatherPoint point = new GatherPoint(floor.toHit(), spacing, facing);
        point.nearness = nearness;
        return point;
    }

    @Test
    void recordsCountFurtherWhereMoreIsFree() {
        assertEquals(2, point(1, 1, 1 / 3.0).radius());
        assertEquals(3.5, point(1, 1, 0.1).radius(), 1e-15);
        assertEquals(6, point(1, 1, 0).radius());
    }

    @Test
    void recordsThatLieFurtherApartCountFurther() {
        assertEquals(6 * 3, point(3, 1, 0).radius());
        assertEquals(2 * 3, point(3, 1, 1).radius());
    }

    /** Seen at a cosine of a quarter, points lie four times as far apart in one direction: the root of it is 2. */
    @Test
    void recordsCountFurtherOnSurfacesThatTheEyeLooksAlong() {
        GatherPoint slanted = point(1, 0.25, 1);
        assertEquals(4, slanted.radius());
        assertEquals(3 * 4 * 4, slanted.wideRadius());
    }
}
