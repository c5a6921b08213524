package raytracing.estimate;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import raytracing.SceneText;
import raytracing.math.Vector;
import raytracing.scene.Scene;
import raytracing.surface.Departure;
import raytracing.surface.HitRecord;
import raytracing.trace.Queries;
import raytracing.trace.ShadowMode;

class DiffusePathsTest {
    /** From the middle of the floor the dome is 10 away in all directions: the record's radius is 0.2 times as much. */
    @Test
    void underADomeTheDistanceToWhatIsAroundIsItsRadius() {
        Scene scene = SceneText.scene("cam 0 6 0  0 5 3  0 1 0  1 1", "set 1 1 1  1 5",
            "mtl 0.5 0.5 0.5  0 0 0  0 0 0  1 0", "pln 0 1 0 5 1", "sph 3 5 -2 10 1");
        HitRecord middle = new HitRecord(0, 0, new Vector(3, 5, -2), 0, new Vector(0, 1, 0), Departure.OUTWARD);
        GatherPoint point = new GatherPoint(middle.toHit(), 1, 1);
        new DiffusePaths(scene, Queries.prepared(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT)).gather(point, false, 1);
        assertEquals(2, point.radius(1), 1e-12);
    }
}
