package raytracing;

import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/** Scenes whose lengths are ten powers of ten apart. What is large there is flat or parallel on paper. */
class LargeAndSmallScenesTest {
    private static final String WHITE = "mtl 1 1 1  0 0 0  0 0 0  1 0";
    private static final String SKY = "set 0.25 0.25 0.25  1 1";

    /**
     * A ball of radius 1/1000 rests on a ground of radius 10^7. At a distance s from where it stands, the ground lies
     * s^2 / (2 * 10^7) below the plane that touches it there. The picture reaches no farther than s = 0.02, so that is
     * less than 2.1e-11: 2e-8 of the smallest length in the picture. So it is the picture of a ball on a flat floor, to
     * half a step of 1/255 as it is shown and to 2e-8 as it is computed (exact arithmetic: to 1.4e-9).
     */
    @ParameterizedTest(name = "to {0}")
    @CsvSource({"0.002", "2e-8"})
    void aTinyBallOnAGroundAsLargeAsAPlanetStandsOnAFlatFloor(double tolerance) {
        BallOverFloor solution = new BallOverFloor(new Vector(0, 1, 0), 1, new Vector(4, 6, -2));
        Vector eye = new Vector(0, 4, -4);
        DrawnPicture.of("cam 0 0.004 -0.004  0 0.001 0  0 1 0  1 0.8", SKY, WHITE, "sph 0 -1e7 0  1e7  1",
            "sph 0 0.001 0  0.001  1", "lgt 0.004 0.006 -0.002  1 1 1  1 1 0")
            .assertSolved(tolerance, (right, up) -> solution.grey(eye,
                new Vector(0.4 * right, -0.6 + 0.4 * up * 0.8, 0.8 + 0.4 * up * 0.6), 1e-6));
    }

    /**
     * From 10^9 away along z, through a screen as far away and 3 wide, a ball of radius 1 is seen by parallel rays: at
     * (x, y) of its disc its normal is (x, y, -sqrt(1 - x x - y y)). Rays that meet at the eye lie within 1.5e-9 of
     * these. A distance of 10^9 rounds by 6e-8, which is all that a hit can be off by, and so 1e-6 is ample for N.L.
     */
    @Test
    void aBallSeenFromABillionRadiiAwayIsSeenByParallelRays() {
        Vector lamp = new Vector(3, 4, -5);
        DrawnPicture.of("cam 0 0 -1e9  0 0 0  0 1 0  1e9 3", SKY, WHITE, "sph 0 0 0 1 1", "lgt 3 4 -5  1 1 1  1 1 0")
            .assertSolved(1e-6, (right, up) -> {
                double x = 1.5 * right;
                double y = 1.5 * up;
                double squaredDepth = 1 - x * x - y * y;
                if (Math.abs(squaredDepth) < 1e-4) {
                    return DrawnPicture.UNDECIDED;
                }
                if (squaredDepth < 0) {
                    return OptionalDouble.of(0.25);
                }
                Vector normal = new Vector(x, y, -Math.sqrt(squaredDepth));
                return OptionalDouble.of(Math.max(0, normal.dot(lamp.minus(normal).unit())));
            });
    }

    /**
     * The same from 10^9 away along a slanted line: every number of a direction rounds by up to 5.5e-17, and a billion
     * times that is 5.5e-8, by which a ray passes beside its place on the screen. The ball magnifies it where it is
     * seen at an angle: at most 1e-3 from its outline, about 22 times. So 1e-5 is ample.
     */
    @Test
    void aBallOnAFloorSeenFromABillionRadiiAwayIsSeenByParallelRays() {
        BallOverFloor solution = new BallOverFloor(new Vector(0, 1, 0), 1, new Vector(4, 6, -2));
        DrawnPicture.of("cam 0 6e8 -8e8  0 0 0  0 1 0  1e9 6", SKY, WHITE, "pln 0 1 0 0 1", "sph 0 1 0 1 1",
            "lgt 4 6 -2  1 1 1  1 1 0")
            .assertSolved(1e-5, (right, up) -> solution.grey(
                new Vector(3 * right, 3 * up * 0.8 + 12, 3 * up * 0.6 - 16), new Vector(0, -0.6, 0.8), 1e-3));
    }

    /**
     * A cube of edge 1 stands on a floor and is seen along (0, -3/5, 4/5) by parallel rays. The point (x, s) of the
     * screen, s upwards, lies on the line (x, 4 s / 5 - 3 r / 5, 3 s / 5 + 4 r / 5), which meets the cube's top y = 1
     * at z = (5 s - 4) / 3, its front z = -1/2 at y = (10 s + 3) / 8, and the floor at z = 5 s / 3. As above, places
     * are right to 1e-7.
     */
    @Test
    void aCubeOnAFloorSeenFromABillionEdgesAwayIsSeenByParallelRays() {
        Vector lamp = new Vector(2, 3, -2);
        PaperBox cube = new PaperBox(new Vector(0, 0.5, 0), 1);
        DrawnPicture.of("cam 0 6e8 -8e8  0 0 0  0 1 0  1e9 4", SKY, WHITE, "pln 0 1 0 0 1", cube.line(1),
            "lgt 2 3 -2  1 1 1  1 1 0").assertSolved(1e-6, (right, up) -> {
                double x = 2 * right;
                Vector top = new Vector(x, 1, (10 * up - 4) / 3);
                Vector front = new Vector(x, (20 * up + 3) / 8, -0.5);
                Vector floor = new Vector(x, 0, 10 * up / 3);
                Vector alongView = new Vector(0, -0.6, 0.8);
                Optional<Boolean> seesCube = cube.isMetBetween(Vectors.plus(floor, -9, alongView), floor);
                Optional<Boolean> isShaded = cube.isMetBetween(floor, lamp);
                if (seesCube.isEmpty() || isShaded.isEmpty() || Math.abs(top.z() + 0.5) < 1e-6) {
                    return DrawnPicture.UNDECIDED;
                }
                if (seesCube.get()) {
                    Vector point = top.z() > -0.5 ? top : front;
                    double facing = top.z() > -0.5 ? lamp.y() - 1 : -0.5 - lamp.z();
                    return OptionalDouble.of(facing / lamp.minus(point).length());
                }
                return OptionalDouble.of(isShaded.get() ? 0 : lamp.y() / lamp.minus(floor).length());
            });
    }
}
