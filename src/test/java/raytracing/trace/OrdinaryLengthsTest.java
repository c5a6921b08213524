package raytracing.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.SceneText;
import raytracing.scene.Scene;

class OrdinaryLengthsTest {
    /** All lengths but those of the screen, times a power of two; normals, which are no lengths, times another. */
    private static Scene scene(double length, double slope) {
        return SceneText.scene("cam 0 " + 2 * length + " " + -4 * length + "  0 " + 0.5 * length + " 0  0 1 0  1 1",
            "set 1 1 1 1 1", "mtl 1 1 1  0 0 0  0 0 0  1 0", "sph 0 " + length + " 0 " + length + " 1",
            "box " + 3 * length + " 0 0 " + 1.5 * length + " 1",
            "pln " + slope + " " + 2 * slope + " 0 " + -3 * (slope * length) + " 1",
            "lgt 0 " + 3 * length + " " + length + "  1 1 1  1 1 " + 0.25 * length);
    }

    @ParameterizedTest
    @ValueSource(ints = {-900, -101, 101, 900})
    void aSceneOfHugeOrTinyLengthsGetsItsMiddleOneNear1(int exponent) {
        assertEquals(scene(1, 1), OrdinaryLengths.of(scene(Math.scalb(1.0, exponent), 1)));
    }

    /** It would be all the others that got out of the ordinary. */
    @Test
    void oneHugeLengthAmongOrdinaryOnesChangesNothing() {
        Scene scene = SceneText.scene("cam 0 0 -4  0 0 1e300  0 1 0  1 1", "set 1 1 1 1 1", "mtl 1 1 1  0 0 0  0 0 0  1 0",
            "sph 0 0 0 1 1", "box 3 0 0 1 1", "lgt 0 1e300 0  0 0 0  1 1 0");
        assertSame(scene, OrdinaryLengths.of(scene));
    }

    @ParameterizedTest
    @ValueSource(ints = {-1000, -101, 101, 1000})
    void aNormalOfHugeOrTinyPartsGetsItsLargestOneNear1(int exponent) {
        assertEquals(scene(1, 0.5), OrdinaryLengths.of(scene(1, Math.scalb(0.5, exponent))));
    }

    @Test
    void aSubnormalSceneBecomesANormalOne() {
        assertEquals(scene(1, 1), OrdinaryLengths.of(scene(0x1p-1040, 1)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 0x1p90, 0x1p-90})
    void ordinaryScenesStayAsTheyAre(double length) {
        Scene scene = scene(length, 1);
        assertSame(scene, OrdinaryLengths.of(scene));
    }

    @Test
    void aSceneWhoseSmallestLengthsWouldLoseDigitsStaysAsItIs() {
        Scene scene = SceneText.scene("cam 0 0 -1e200  0 0 0  0 1 0  1 1", "set 1 1 1 1 1",
            "mtl 1 1 1  0 0 0  0 0 0  1 0", "sph 0 0 0 1e-290 1");
        assertSame(scene, OrdinaryLengths.of(scene));
    }
}
