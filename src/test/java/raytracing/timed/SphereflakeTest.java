package raytracing.timed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.math.Vector;
import raytracing.scene.Scene;
import raytracing.surface.Sphere;

class SphereflakeTest {
    /** Coordinates below 2 of nine digits, a few in each sum. */
    private static final double ROUNDING = 1e-7;
    private static final int CHILDREN = 9;

    private final List<Sphere> balls = balls(Sphereflake.scene(4, 1));

    private static List<Sphere> balls(Scene scene) {
        List<Sphere> spheres = new ArrayList<>();
        scene.surfaces().stream().filter(Sphere.class::isInstance).map(Sphere.class::cast).forEach(spheres::add);
        return spheres;
    }

    private Sphere parent(int ball) {
        return balls.get((ball - 1) / CHILDREN);
    }

    private static double gap(Sphere one, Sphere other) {
        return one.centre().minus(other.centre()).length() - one.radius() - other.radius();
    }

    /** 1 + 9 + 81 + ... = (9^(levels + 1) - 1) / 8, and the floor. */
    @ParameterizedTest
    @CsvSource({"0, 1", "1, 10", "2, 91", "3, 820", "4, 7381", "5, 66430", "6, 597871"})
    void everyLevelHasNineTimesTheBallsOfTheOneBefore(int levels, int count) {
        assertEquals(count + 1, Sphereflake.scene(levels, 1).surfaces().size());
    }

    @Test
    void everyChildTouchesItsParent() {
        for (int i = 1; i < balls.size(); i++) {
            assertEquals(0, gap(balls.get(i), parent(i)), ROUNDING, "ball " + i);
        }
    }

    @Test
    void everyChildIsAThirdOfItsParent() {
        for (int i = 1; i < balls.size(); i++) {
            assertEquals(parent(i).radius() / 3, balls.get(i).radius(), ROUNDING, "ball " + i);
        }
    }

    /** In a closest packing six directions are 60 degrees apart, and each of the upper three is so from two of them. */
    @Test
    void noTwoChildrenOfABallAreNearerThanSixtyDegrees() {
        for (int first = 1; first < balls.size(); first += CHILDREN) {
            int sixtyDegreesApart = 0;
            for (int i = first; i < first + CHILDREN; i++) {
                for (int j = first; j < i; j++) {
                    double cosine = direction(i).dot(direction(j));
                    assertTrue(cosine < 0.5 + 1e-5, "balls " + i + ", " + j);
                    sixtyDegreesApart += cosine > 0.5 - 1e-5 ? 1 : 0;
                }
            }
            assertEquals(6 + 3 * 2 + 3, sixtyDegreesApart, "children from ball " + first);
        }
    }

    private Vector direction(int ball) {
        return balls.get(ball).centre().minus(parent(ball).centre()).unit();
    }

    @Test
    void noChildReachesIntoItsGrandparent() {
        for (int i = CHILDREN + 1; i < balls.size(); i++) {
            assertTrue(gap(balls.get(i), parent((i - 1) / CHILDREN)) > 0, "ball " + i);
        }
    }

    @Test
    void nothingReachesBelowTheFloor() {
        assertTrue(balls.stream().allMatch(ball -> ball.centre().y() - ball.radius() >= -1));
    }

    @Test
    void shadowRaysAreAsManyAsAskedFor() {
        assertEquals(3, Sphereflake.scene(0, 3).settings().shadowRayRoot());
    }
}
