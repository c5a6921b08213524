package raytracing.shade;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import raytracing.SceneText;
import raytracing.compiled.CompiledScene;
import raytracing.compiled.ShadowMode;
import raytracing.geometry.Departure;
import raytracing.geometry.Hit;
import raytracing.geometry.HitPoint;
import raytracing.math.Vector;
import raytracing.scene.Scene;

class DiffusePathsTest {
    /** Whatever way a ray goes from the middle of the floor, the dome is 10 away: the place reaches 0.35 times as far. */
    @Test
    void underADomeTheDistanceToWhatIsAroundIsItsRadius() {
        Scene scene = SceneText.scene("cam 0 6 0  0 5 3  0 1 0  1 1", "set 1 1 1  1 5",
            "mtl 0.5 0.5 0.5  0 0 0  0 0 0  1 0", "pln 0 1 0 5 1", "sph 3 5 -2 10 1");
        HitPoint middle = new HitPoint();
        middle.take(new Hit(0, 0, 1, new Vector(3, 5, -2), 0, new Vector(0, 1, 0), Departure.OUTWARD));
        Place place = new Place(middle, 1, 1);
        new DiffusePaths(scene, new CompiledScene(scene, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT)).gather(place, 1);
        assertEquals(3.5, place.radius(), 1e-12);
    }
}
