package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.film.Film;
import raytracing.render.RenderSettings;

/**
 * Whole pictures of scenes solved on paper. Each test derives the grey of every pixel from the place (right, up) where
 * its centre meets the screen, which is 1 away from the eye and 2 wide unless the test says otherwise.
 */
class SolvedPicturesTest {
    private static final int SIZE = 40;
    private static final double ROUNDING = 1e-12;
    private static final String WHITE = "mtl 1 1 1  0 0 0  0 0 0  1 0";

    /** The grey that a pixel must have, by where its centre meets the screen. */
    private interface Solution {
        double grey(double right, double up);
    }

    private static void assertPicture(Solution solution, String... lines) {
        Film film = Steps.renderScene(SceneText.scene(lines), RenderSettings.DEFAULT.withSize(SIZE, SIZE));
        Set<Double> greys = new HashSet<>();
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                double right = (x + 0.5 - SIZE / 2.0) * 2 / SIZE;
                double up = (SIZE / 2.0 - (y + 0.5)) * 2 / SIZE;
                double expected = solution.grey(right, up);
                assertEquals(expected, film.get(x, y).green(), ROUNDING, "pixel " + x + ", " + y);
                assertEquals(Math.round(255 * Math.min(1, expected)), film.toImage().getRGB(x, y) & 0xff,
                    "pixel " + x + ", " + y);
                greys.add(expected);
            }
        }
        assertTrue(greys.size() > 1, "an even picture proves nothing");
    }

    /** The eye carries the lamp, 1 above the floor: N.L is the downward part of the unit direction. */
    @Test
    void aFloorUnderALampAtTheEye() {
        assertPicture((right, up) -> up > 0 ? 0.25 : -up / Math.sqrt(right * right + up * up + 1),
            "cam 0 1 0  0 1 1  0 1 0  1 2", "set 0.25 0.25 0.25 1 1", WHITE, "pln 0 1 0 0 1", "lgt 0 1 0 1 1 1 1 1 0");
    }

    /**
     * A ball of radius 1, 2 away, under a lamp at the eye. The eye's ray at an angle theta to the middle meets it if
     * 2 sin(theta) is at most 1, and then under the angle whose sine is 2 sin(theta): by the law of sines.
     */
    @Test
    void aBallUnderALampAtTheEye() {
        assertPicture((right, up) -> {
            double squaredSine = 4 * (right * right + up * up) / (right * right + up * up + 1);
            return squaredSine > 1 ? 0.5 : Math.sqrt(1 - squaredSine);
        }, "cam 0 0 0  0 0 1  0 1 0  1 2", "set 0.5 0.5 0.5 1 1", WHITE, "sph 0 0 2 1 1", "lgt 0 0 0 1 1 1 1 1 0");
    }

    /** The near face of a cube of edge 2, 2 away: on the screen a square from -1/2 to 1/2, seen through its normal. */
    @Test
    void theFaceOfACubeUnderALampAtTheEye() {
        assertPicture((right, up) -> Math.max(Math.abs(right), Math.abs(up)) > 0.5
                ? 0.5 : 1 / Math.sqrt(right * right + up * up + 1),
            "cam 0 0 0  0 0 1  0 1 0  1 2", "set 0.5 0.5 0.5 1 1", WHITE, "box 0 0 3 2 1", "lgt 0 0 0 1 1 1 1 1 0");
    }

    /**
     * Seen from 4 above the floor, straight down, a ball of radius 1/2 at height 2 hides a circle and, from a lamp 4
     * above the floor and 2 aside, throws a shadow. A point P of the floor is in it if the distance of the ball's centre
     * C from the line to the lamp L, |(C - P) x (L - P)| / |L - P|, is below 1/2. With N.L = 4 / |L - P|.
     */
    @Test
    void theHardShadowOfABallOnAFloor() {
        assertPicture((right, up) -> {
            double offAxis = 4 * (right * right + up * up) / (right * right + up * up + 1);
            if (offAxis <= 0.25) {
                return 0;                    // the ball itself is black
            }
            double x = 4 * right;
            double z = 4 * up;
            double lx = 2 - x;
            double lz = -z;
            double length = Math.sqrt(lx * lx + 16 + lz * lz);
            double cross = Math.sqrt(Math.pow(2 * lz - 4 * -z, 2) + Math.pow(-z * lx - -x * lz, 2)
                + Math.pow(4 * -x - 2 * lx, 2));
            return cross / length < 0.5 ? 0.3 * 4 / length : 4 / length;
        }, "cam 0 4 0  0 0 0  0 0 1  1 2", "set 0 0 0 1 1", WHITE, "mtl 0 0 0  0 0 0  0 0 0  1 0",
            "pln 0 1 0 0 1", "sph 0 2 0 0.5 2", "lgt 2 4 0 1 1 1 1 0.7 0");
    }

    /**
     * A black cube of edge 1 stands on a mirror of 1/2, its face 3 away from an eye 1 above the mirror. On the screen the
     * face reaches a sixth to either side and from the horizon, for it is as high as the eye, down to 1/3; below hangs
     * its mirror image, down to 2/3. The rest is sky, above as it is, below halved.
     */
    @Test
    void aCubeOnAMirrorAndItsImage() {
        assertPicture((right, up) -> {
            if (Math.abs(right) < 1 / 6.0 && up < 0 && up > -2 / 3.0) {
                return 0;
            }
            return up > 0 ? 0.8 : 0.4;
        }, "cam 0 1 0  0 1 1  0 1 0  1 2", "set 0.8 0.8 0.8 1 5", "mtl 0 0 0  0 0 0  0.5 0.5 0.5  1 0",
            "mtl 0 0 0  0 0 0  0 0 0  1 0", "pln 0 1 0 0 1", "box 0 0.5 3.5 1 2");
    }

    /** Where the ball of the second test stands, one of glass dims the sky to 3/4, once, and adds 1/5 of it mirrored. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1})
    void aGlassBallBeforeTheSky(int mostReflections) {
        assertPicture((right, up) -> 4 * (right * right + up * up) / (right * right + up * up + 1) > 1 ? 0.5 : 0.475,
            "cam 0 0 0  0 0 1  0 1 0  1 2", "set 0.5 0.5 0.5 1 " + mostReflections,
            "mtl 0 0 0  0 0 0  0.2 0.2 0.2  1 0.75", "sph 0 0 2 1 1");
    }

    /** Sky all around, seen through a fisheye 0.4 away from the screen: a disc, black outside the radius of 90 degrees. */
    @ParameterizedTest(name = "k = {0}: radius {1}")
    @CsvSource({"0.5, 0.8", "0, 0.6283185307179586", "-0.5, 0.565685424949238", "-1, 0.4"})
    void theSkyThroughAFisheyeIsADisc(double k, double radius) {
        assertPicture((right, up) -> right * right + up * up < radius * radius ? 0.6 : 0,
            "cam 0 0 0  0 0 1  0 1 0  0.4 2 true " + k, "set 0.6 0.6 0.6 1 1");
    }

    /** The equidistant lens sees a ball of angular radius 30 degrees as a disc of radius f times that angle. */
    @Test
    void aBallInTheMiddleOfAnEquidistantFisheye() {
        double radius = 0.5 * Math.toRadians(30);
        assertPicture((right, up) -> {
            double fromMiddle = Math.sqrt(right * right + up * up);
            return fromMiddle < radius ? 0 : fromMiddle < 0.5 * Math.PI / 2 ? 0.6 : 0;
        }, "cam 0 0 0  0 0 1  0 1 0  0.5 2 true 0", "set 0.6 0.6 0.6 1 1", WHITE, "sph 0 0 2 1 1");
    }
}
