package raytracing.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.math.Vector;
import raytracing.surface.Ray;
import raytracing.surface.RayRecord;

/** A camera in the origin looks along +z at a screen 2 away and 4 wide, unless a test says otherwise. */
class CameraRaysTest {
    private static final double FOUR_ULP = 4 * Math.ulp(1.0);

    private static CameraRays rays(Lens lens, int width, int height) {
        Camera camera = new Camera(Vector.ZERO, new Vector(0, 0, 9), new Vector(0, 1, 0), 2, 4, lens);
        return new CameraRays(camera, width, height);
    }

    private static Optional<RayRecord> through(CameraRays rays, double x, double y) {
        Ray ray = new Ray();
        return rays.start(x, y, ray) ? Optional.of(RayRecord.of(ray)) : Optional.empty();
    }

    private static Vector direction(CameraRays rays, double x, double y) {
        return through(rays, x, y).orElseThrow().direction();
    }

    private static void assertAlong(Vector expected, Vector direction) {
        Vector unit = expected.unit();
        assertEquals(unit.x(), direction.x(), FOUR_ULP);
        assertEquals(unit.y(), direction.y(), FOUR_ULP);
        assertEquals(unit.z(), direction.z(), FOUR_ULP);
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "upper left corner,    0,   0,  -2,  1.5",
        "upper right corner, 400,   0,   2,  1.5",
        "lower left corner,    0, 300,  -2, -1.5",
        "lower right corner, 400, 300,   2, -1.5",
        "middle,             200, 150,   0,    0",
        "centre of the first pixel,  0.5,  0.5, -1.995,  1.495",
        "centre of the last pixel, 399.5, 299.5, 1.995, -1.495",
    })
    void theScreenIsAsWideAsTheSceneSaysAndAsHighAsThePicturesShape(String why, double x, double y,
                                                                    double right, double up) {
        assertAlong(new Vector(right, up, 2), direction(rays(new Pinhole(), 400, 300), x, y));
    }

    @Test
    void aPictureOfOnePixelLooksStraightAhead() {
        assertEquals(new Vector(0, 0, 1), direction(rays(new Pinhole(), 1, 1), 0.5, 0.5));
    }

    @Test
    void raysStartAtTheCameraAndHaveUnitDirections() {
        Camera camera = new Camera(new Vector(1, 2, 3), new Vector(-4, 0, 9), new Vector(0.3, 1, 0), 2, 4,
            new Pinhole());
        CameraRays rays = new CameraRays(camera, 40, 30);
        for (int x = 0; x <= 40; x++) {
            RayRecord ray = through(rays, x, x / 2.0).orElseThrow();
            assertEquals(camera.position(), ray.origin());
            assertEquals(1, ray.direction().length(), FOUR_ULP);
        }
    }

    @Test
    void aCameraLookingAlongMinusZHasMinusXOnItsRight() {
        Camera camera = new Camera(Vector.ZERO, new Vector(0, 0, -1), new Vector(0, 1, 0), 1, 2, new Pinhole());
        assertAlong(new Vector(-1, 0, -1), direction(new CameraRays(camera, 2, 2), 2, 1));
    }

    @Test
    void aFisheyeOfKOneIsThePinholeBitForBit() {
        CameraRays pinhole = rays(new Pinhole(), 64, 48);
        CameraRays fisheye = rays(new Fisheye(1), 64, 48);
        for (int y = 0; y < 48; y++) {
            for (int x = 0; x < 64; x++) {
                assertEquals(through(pinhole, x + 0.5, y + 0.5), through(fisheye, x + 0.5, y + 0.5));
            }
        }
    }

    /** Close to k = 1 the general formula takes over; it must agree with the pinhole it does not share code with. */
    @Test
    void aFisheyeJustBelowKOneIsAlmostThePinhole() {
        CameraRays pinhole = rays(new Pinhole(), 64, 48);
        CameraRays fisheye = rays(new Fisheye(Math.nextDown(1.0)), 64, 48);
        for (int x = 0; x < 64; x++) {
            assertAlong(direction(pinhole, x + 0.5, 10.5), direction(fisheye, x + 0.5, 10.5));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-12, -1e-12})
    void aFisheyeIsSmoothThroughKZero(double k) {
        CameraRays atZero = rays(new Fisheye(0), 64, 48);
        CameraRays near = rays(new Fisheye(k), 64, 48);
        for (int x = 0; x < 64; x++) {
            Vector difference = direction(atZero, x + 0.5, 3.5).minus(direction(near, x + 0.5, 3.5));
            assertTrue(difference.length() < 2e-12);
        }
    }

    /** Equidistant: half way to the right edge is the screen's radius 1, at distance 2: half a radian. */
    @Test
    void anEquidistantFisheyeTurnsRadiusIntoAngle() {
        assertAlong(new Vector(Math.sin(0.5), 0, Math.cos(0.5)), direction(rays(new Fisheye(0), 400, 400), 300, 200));
        assertAlong(new Vector(0, -Math.sin(0.25), Math.cos(0.25)),
            direction(rays(new Fisheye(0), 400, 400), 200, 250));
    }

    @Test
    void theMiddleOfAFisheyeLooksStraightAhead() {
        assertEquals(new Vector(0, 0, 1), direction(rays(new Fisheye(-0.5), 3, 3), 1.5, 1.5));
    }

    @ParameterizedTest(name = "k {0}: black beyond radius {1}")
    @CsvSource({
        // theta = 90 degrees at R = f tan(k 90) / k, f 90, f sin(k 90) / k; f = 2
        "0.5,  4",
        "0,    3.141592653589793",
        "-0.5, 2.8284271247461903",
        "-1,   2",
    })
    void theCircleOfARightAngleIsTheEdgeOfThePicture(double k, double radius) {
        Camera camera = new Camera(Vector.ZERO, new Vector(0, 0, 1), new Vector(0, 1, 0), 2, 20, new Fisheye(k));
        CameraRays rays = new CameraRays(camera, 20, 20);
        assertTrue(through(rays, 10 + radius * 0.999_999, 10).isPresent());
        assertEquals(Optional.empty(), through(rays, 10 + radius * 1.000_001, 10));
        assertEquals(Optional.empty(), through(rays, 20, 20));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 0.5, 0, -1})
    void scalingTheSceneByAPowerOfTwoDoesNotTurnARayByABit(double k) {
        Camera camera = new Camera(Vector.ZERO, new Vector(1, 2, 3), new Vector(0, 1, 0), 0.7, 1.3, new Fisheye(k));
        Camera larger = new Camera(Vector.ZERO, new Vector(1, 2, 3).times(0x1p40), new Vector(0, 1, 0),
            0.7 * 0x1p40, 1.3 * 0x1p40, new Fisheye(k));
        for (int x = 0; x < 50; x++) {
            assertEquals(through(new CameraRays(camera, 50, 50), x + 0.5, 20.5).map(RayRecord::direction),
                through(new CameraRays(larger, 50, 50), x + 0.5, 20.5).map(RayRecord::direction));
        }
    }

    @ParameterizedTest(name = "distance {0}, width {1}")
    @CsvSource({"1e308, 1e308", "4.9e-324, 4.9e-324", "1.7e308, 4.9e-324", "4.9e-324, 1.7e308"})
    void screensOfEverySizeADoubleCanHoldHaveRays(double distance, double screenWidth) {
        Camera camera = new Camera(Vector.ZERO, new Vector(0, 0, 1), new Vector(0, 1, 0), distance, screenWidth,
            new Pinhole());
        CameraRays rays = new CameraRays(camera, 1, 9);
        for (int y = 0; y <= 9; y++) {
            assertEquals(1, direction(rays, 0.25, y).length(), FOUR_ULP);
        }
    }

    /**
     * Sizes of screens all over the range of doubles: half of them with distance and width of ordinary ratios. The camera's
     * axes are (-0.8, 0.6, 0), (0, 0, 1) and (0.6, 0.8, 0). The cosine of an angle at which a lens turns black is compared
     * no closer than 10^-6 to 0: an orthographic lens takes the root of what is left of 1 there.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1, 0.5, 0, -0.5, -1})
    void directionsAreRightToRoundingWhateverTheSizesOfTheScreen(double k) {
        SplittableRandom random = new SplittableRandom(31);
        int seen = 0;
        int black = 0;
        List<String> wrong = new ArrayList<>();
        for (int i = 0; i < 2000; i++) {
            double distance = power(random, -323.3, 308.2);
            double width = random.nextBoolean() ? power(random, -323.3, 308.2)
                : Math.max(Double.MIN_VALUE, Math.min(Double.MAX_VALUE, distance * power(random, -2, 2)));
            int columns = random.nextInt(1, 20);
            int rows = random.nextInt(1, 20);
            double x = random.nextInt(columns) + random.nextInt(1, 9) / 8.0;
            double y = random.nextInt(rows) + (random.nextBoolean() ? 0.5 : random.nextDouble());
            Optional<ExactCameraRay> exact = ExactCameraRay.of(distance, width, columns, rows, x, y, k);
            Camera camera = new Camera(Vector.ZERO, new Vector(3, 4, 0), new Vector(0, 0, 7), distance, width,
                new Fisheye(k));
            Optional<RayRecord> found = through(new CameraRays(camera, columns, rows), x, y);
            if (exact.isPresent() && exact.get().forward().doubleValue() < 1e-6 && k != 1) {
                continue;
            }
            if (!isRight(exact, found)) {
                wrong.add(camera + " " + columns + " x " + rows + " at " + x + ", " + y + ": " + found + ", not " + exact);
            }
            seen += exact.isPresent() ? 1 : 0;
            black += exact.isPresent() ? 0 : 1;
        }
        assertEquals(List.of(), wrong);
        assertTrue(seen > 500 && (black > 500 || k == 1), "too few to mean anything: " + seen + ", " + black);
    }

    private static double power(SplittableRandom random, double lowest, double highest) {
        return Math.max(Double.MIN_VALUE, StrictMath.pow(10, random.nextDouble(lowest, highest)));
    }

    private static boolean isRight(Optional<ExactCameraRay> exact, Optional<RayRecord> found) {
        if (exact.isEmpty() || found.isEmpty()) {
            return exact.isEmpty() && found.isEmpty();
        }
        double right = exact.get().right().doubleValue();
        double forward = exact.get().forward().doubleValue();
        Vector expected = new Vector(0.6 * forward - 0.8 * right, 0.8 * forward + 0.6 * right,
            exact.get().up().doubleValue());
        return expected.minus(found.get().direction()).largestPart() <= exact.get().most();
    }

    @ParameterizedTest(name = "distance {0}, width {1}")
    @CsvSource({"1e-300, 1e300", "4.9e-324, 1.7e308", "2.2e-308, 1e300", "1e-160, 1e160", "1, 1", "1e-310, 1e-310",
        "4.9e-324, 4.9e-324", "1.7e308, 1.7e308", "1e300, 1e-300", "1.7e308, 4.9e-324"})
    void theMiddleOfAPictureIsInTheMiddleOfTheViewWhateverTheSizesOfTheScreen(double distance, double screenWidth) {
        Vector lookAt = new Vector(-3, 1, 7);
        for (double k : new double[] {1, 0.999, 0.5, 1e-300, 0, -1e-300, -0.5, -1}) {
            Camera camera = new Camera(Vector.ZERO, lookAt, new Vector(0, 1, 0), distance, screenWidth, new Fisheye(k));
            Vector direction = direction(new CameraRays(camera, 5, 3), 2.5, 1.5);
            assertTrue(lookAt.unit().minus(direction).largestPart() <= Math.ulp(1.0), k + ": " + direction);
        }
    }

    /** An infinite tangent: but for the middle, a pinhole sees only what is beside it, and a fisheye nothing. */
    @Test
    void aScreenWhoseDistanceIsNothingBesideItsWidthShowsWhatIsSideways() {
        CameraRays pinhole = tiny(1);
        CameraRays fisheye = tiny(0.5);
        for (int y = 0; y < 5; y++) {
            for (int x = 0; x < 5; x++) {
                if (x != 2 || y != 2) {
                    assertAlong(new Vector(x - 2, 2 - y, 0), direction(pinhole, x + 0.5, y + 0.5));
                    assertEquals(0, direction(pinhole, x + 0.5, y + 0.5).z());
                    assertEquals(Optional.empty(), through(fisheye, x + 0.5, y + 0.5));
                }
            }
        }
    }

    private static CameraRays tiny(double k) {
        return new CameraRays(new Camera(Vector.ZERO, new Vector(0, 0, 1), new Vector(0, 1, 0), 1e-300, 1e300,
            new Fisheye(k)), 5, 5);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 0.5, 0, -1})
    void aScreenWhoseWidthIsNothingBesideItsDistanceShowsThePointInTheMiddle(double k) {
        Camera camera = new Camera(Vector.ZERO, new Vector(0, 0, 1), new Vector(0, 1, 0), 1e300, 1e-300, new Fisheye(k));
        for (int x = 0; x < 4; x++) {
            assertEquals(new Vector(0, 0, 1), direction(new CameraRays(camera, 4, 4), x + 0.5, 0.5));
        }
    }
}
