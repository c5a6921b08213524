package raytracing.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import raytracing.math.Vector;

class CameraTest {
    private static Camera from(Vector position, Vector lookAt) {
        return new Camera(position, lookAt, new Vector(0, 2, 0), 1, 1, new Pinhole());
    }

    private static Camera alongZ(Vector up) {
        return new Camera(Vector.ZERO, new Vector(0, 0, 9), up, 1, 1, new Pinhole());
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
    void itHasXOnItsRightWhenItLooksAlongZ() {
        assertEquals(new Vector(1, 0, 0), alongZ(new Vector(0, 2, 0)).right());
    }

    @Test
    void aSlantedUpIsMadePerpendicular() {
        Vector right = alongZ(new Vector(0, 1, 5)).right();
        assertEquals(1, right.length(), 8 * Math.ulp(1.0));
        assertEquals(1, right.x(), 8 * Math.ulp(1.0));
    }

    @Test
    void upAlongTheViewIsRefused() {
        assertThrows(ArithmeticException.class, () -> alongZ(new Vector(0, 0, -1)).right());
    }
}
