package raytracing.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import raytracing.math.Vector;

class CameraTest {
    private static Camera from(Vector position, Vector lookAt) {
        return new Camera(position, lookAt, new Vector(0, 2, 0), 1, 1, new Pinhole());
    }

    @Test
    void itLooksFromItsPositionToTheLookAtPoint() {
        assertEquals(new Vector(0, 0, 1), from(new Vector(1, 2, 3), new Vector(1, 2, 8)).forward());
    }

    @Test
    void pointsTooFarApartForADoubleStillHaveADirection() {
        Camera camera = from(new Vector(-1.5e308, 0, 0), new Vector(1.5e308, 0, 0));
        assertEquals(new Vector(1, 0, 0), camera.forward());
    }

    @Test
    void itsAxesHaveXOnTheRightWhenItLooksAlongZ() {
        assertEquals(new Vector(1, 0, 0), from(Vector.ZERO, new Vector(0, 0, 9)).basis().u());
    }
}
