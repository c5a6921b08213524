package raytracing;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/**
 * Where surfaces touch or coincide, rounding puts points on the wrong side of one of them: dark specks in the light,
 * and light in the dark. These scenes have decimal coordinates, whose faces are not doubles, and every pixel is held to
 * the light that it must have or must not have.
 */
class NoSpeckTest {
    private static final double ROUNDING = 1e-9;
    private static final double OPEN = 1e-7;
    private static final String WHITE = "mtl 1 1 1  0 0 0  0 0 0  1 0";
    private static final String SKY = "set 0.25 0.25 0.25  1 1";

    /** Cubes of edge 0.3, 0.2 and 0.1, one on the other, their fronts in the plane z = -0.15. */
    private static final List<PaperBox> STACK = List.of(new PaperBox(new Vector(0, 0.15, 0), 0.3),
        new PaperBox(new Vector(0, 0.4, -0.05), 0.2), new PaperBox(new Vector(0, 0.55, -0.1), 0.1));

    /** The empty cube in the middle of 3 x 3 x 3. */
    private static final PaperBox ROOM = new PaperBox(new Vector(0.3, 0.7, 0.2), 0.1);

    /** A ball that touches the floor, seen from so low that the place where they touch is in view. */
    private static final BallOverFloor BALL = new BallOverFloor(new Vector(0, 1, 0), 1, new Vector(3, 4, -1));
    private static final Vector LOW_EYE = new Vector(0, 0.3, -3);

    private static final Vector DOWN = new Vector(0, -1, 0);

    private static DrawnPicture picture(String camera, Vector lamp, List<PaperBox> boxes, String... others) {
        List<String> lines = new ArrayList<>(List.of(camera, SKY, WHITE,
            "lgt" + DrawnPicture.numbers(lamp) + "1 1 1  1 1 0"));
        boxes.forEach(box -> lines.add(box.line(1)));
        lines.addAll(List.of(others));
        return DrawnPicture.of(lines.toArray(String[]::new));
    }

    /** Whether a line between two points meets any of the cubes; empty close to an outline. */
    private static Optional<Boolean> meetsAny(List<PaperBox> boxes, Vector from, Vector to) {
        List<Optional<Boolean>> answers = boxes.stream().map(box -> box.isMetBetween(from, to)).toList();
        if (answers.contains(Optional.of(true))) {
            return Optional.of(true);
        }
        return answers.contains(Optional.<Boolean>empty()) ? Optional.empty() : Optional.of(false);
    }

    /** What a surface shows whose N.L is known, if these cubes are all that may stand between it and the lamp. */
    private static OptionalDouble shadedBy(List<PaperBox> boxes, Vector point, Vector lamp, double facing) {
        Optional<Boolean> isShaded = meetsAny(boxes, point, lamp);
        return isShaded.isEmpty() ? DrawnPicture.UNDECIDED : OptionalDouble.of(isShaded.get() ? 0 : facing);
    }

    /**
     * The eye at (0, 0.25, -1) is too low for any top, so it sees fronts only, 0.85 away. All lamps stand before them,
     * where no cube shades another's front: N.L is the lamp's distance from their plane over its distance.
     */
    @ParameterizedTest
    @CsvSource({"0.4, 1, -1", "0.1, 3, -0.25", "2, 0.3, -0.16", "-2, 0.5, -0.2", "0, 0.25, -1"})
    void everyFrontOfAStackOfTouchingBoxesHasItsLight(double x, double y, double z) {
        Vector lamp = new Vector(x, y, z);
        Vector through = new Vector(0, 0, 0.01);
        picture("cam 0 0.25 -1  0 0.25 0  0 1 0  1 1", lamp, STACK).assertSolved(ROUNDING, (right, up) -> {
            Vector point = new Vector(0.425 * right, 0.25 + 0.425 * up, -0.15);
            Optional<Boolean> seesStack = meetsAny(STACK, point.minus(through), Vectors.plus(point, through));
            if (seesStack.isEmpty()) {
                return DrawnPicture.UNDECIDED;
            }
            return OptionalDouble.of(seesStack.get() ? (-0.15 - z) / lamp.minus(point).length() : 0.25);
        });
    }

    /**
     * The eye is straight above all three cubes, so it sees tops only, the highest first, and the floor. On each, N.L
     * is the lamp's height above it over its distance, unless a cube that stands on it is in between.
     */
    @ParameterizedTest
    @CsvSource({"0.02, 3, -0.1", "-0.5, 1, -0.1", "1, 0.7, 0.5"})
    void everyTopOfAStackOfTouchingBoxesHasItsLight(double x, double y, double z) {
        Vector lamp = new Vector(x, y, z);
        picture("cam 0 1.6 -0.1  0 0 -0.1  0 0 1  1 0.6", lamp, STACK, "pln 0 1 0 0 1")
            .assertSolved(ROUNDING, (right, up) -> fromAbove(new Vector(0.3 * right, -1, 0.3 * up), lamp));
    }

    private static OptionalDouble fromAbove(Vector ray, Vector lamp) {
        Vector eye = new Vector(0, 1.6, -0.1);
        for (int i = STACK.size() - 1; i >= 0; i--) {
            double top = STACK.get(i).centre().y() + STACK.get(i).edge() / 2;
            Vector point = Vectors.plus(eye, 1.6 - top, ray);
            Optional<Boolean> isThere = STACK.get(i).isMetBetween(Vectors.plus(point, -0.01, DOWN),
                Vectors.plus(point, 0.01, DOWN));
            if (isThere.isEmpty()) {
                return DrawnPicture.UNDECIDED;
            }
            if (isThere.get()) {
                List<PaperBox> above = STACK.subList(i + 1, STACK.size());
                return shadedBy(above, point, lamp, (lamp.y() - top) / lamp.minus(point).length());
            }
        }
        Vector floor = Vectors.plus(eye, 1.6, ray);
        return shadedBy(STACK, floor, lamp, lamp.y() / lamp.minus(floor).length());
    }

    /** The eye looks straight down, past the stack, on the floor where the shadow of all three cubes falls. */
    @ParameterizedTest
    @CsvSource({"-0.5, 1, 0", "-0.6, 0.9, 0.4", "-0.4, 2, -0.1"})
    void theShadowOfAStackOfTouchingBoxesHasNoLightInItsJoints(double x, double y, double z) {
        Vector lamp = new Vector(x, y, z);
        picture("cam 0.5 1 0  0.5 0 0  0 0 1  1 0.6", lamp, STACK, "pln 0 1 0 0 1")
            .assertSolved(ROUNDING, (right, up) -> {
                Vector point = new Vector(0.5 + 0.3 * right, 0, 0.3 * up);
                return shadedBy(STACK, point, lamp, y / lamp.minus(point).length());
            });
    }

    /**
     * Two cubes touch at a height at which also the lamp before them stands; behind them the eye looks at a wall, its
     * middle row exactly at that height, where light would run in the joint. A joint has no width: it is dark where a
     * millionth below it the lower cube, or a millionth above it the upper cube, hides the light. The faces at c + e/2 and
     * c - e/2 are no doubles, and in the last two rows the double of the height lies in a gap of less than 1e-16 between them.
     */
    @ParameterizedTest(name = "{0} +- {1} / 2 below {2} -+ {3} / 2")
    @CsvSource({
        "0.15,  0.3, 0.35, 0.1, 0.3",
        "0.4,   0.2, 0.55, 0.1, 0.5",
        "-0.1,  0.8, 0.45, 0.3, 0.3",
        "0.35,  0.7, 0.75, 0.1, 0.7",
        "0.45,  0.9,    1, 0.2, 0.9",
        "-0.55, 1.3, 0.15, 0.1, 0.1",
        "0.55,  0.1, 0.75, 0.3, 0.6",
        "0.7,   0.3,    1, 0.3, 0.85",
        "0.7,   0.1,  0.8, 0.1, 0.75",
    })
    void noLightRunsInTheJointOfTwoBoxes(double lower, double lowerEdge, double upper, double upperEdge,
                                         double joint) {
        List<PaperBox> boxes = List.of(new PaperBox(new Vector(0, lower, 0), lowerEdge),
            new PaperBox(new Vector(0, upper, 0), upperEdge));
        Vector lamp = new Vector(0.05, joint, -1);
        Vector aside = DOWN.times(1e-6);
        picture("cam 0 " + joint + " 1  0 " + joint + " 2  0 1 0  1 2", lamp, boxes, "pln 0 0 1 2 1")
            .assertSolved(ROUNDING, (right, up) -> {
                Vector point = new Vector(right, joint + up, 2);
                double light = 3 / lamp.minus(point).length();
                OptionalDouble below = shadedBy(boxes, Vectors.plus(point, aside), Vectors.plus(lamp, aside), light);
                OptionalDouble above = shadedBy(boxes, point.minus(aside), lamp.minus(aside), light);
                return below.isEmpty() || above.isEmpty() ? OptionalDouble.empty()
                    : OptionalDouble.of(Math.min(below.getAsDouble(), above.getAsDouble()));
            });
    }

    private static List<PaperBox> aroundTheRoom() {
        List<PaperBox> cubes = new ArrayList<>();
        for (double x : List.of(0.2, 0.3, 0.4)) {
            for (double y : List.of(0.6, 0.7, 0.8)) {
                for (double z : List.of(0.1, 0.2, 0.3)) {
                    cubes.add(new PaperBox(new Vector(x, y, z), 0.1));
                }
            }
        }
        cubes.remove(ROOM);
        return cubes;
    }

    /**
     * A closed room of touching cubes, a lamp in it or on its wall, a floor below, a sky above: outside, whatever is on
     * the cubes and below the horizon is black. The middle column of the picture looks along a joint, x = 0.25 or 0.35,
     * in which two of the lamps stand.
     */
    @ParameterizedTest
    @CsvSource({"0.25, 0.3, 0.7, 0.2", "0.25, 0.26, 0.74, 0.2", "0.25, 0.25, 0.7, 0.2", "0.35, 0.35, 0.66, 0.17"})
    void noLightLeavesAClosedRoomOfTouchingBoxes(double joint, double x, double y, double z) {
        PaperBox block = new PaperBox(ROOM.centre(), 0.3);
        Vector eye = new Vector(joint, 0.65, -0.3);
        String camera = "cam" + DrawnPicture.numbers(eye) + joint + " 0.65 0  0 1 0  1 2";
        picture(camera, new Vector(x, y, z), aroundTheRoom(), "pln 0 1 0 0.4 1").assertSolved(0, (right, up) -> {
            Optional<Boolean> seesBlock = block.isMetBetween(eye, Vectors.plus(eye, new Vector(right, up, 1)));
            if (seesBlock.isEmpty()) {
                return DrawnPicture.UNDECIDED;
            }
            return OptionalDouble.of(seesBlock.get() || up < 0 ? 0 : 0.25);
        });
    }

    /** The same room from inside: six walls, each of one cube, and no joint to be seen. */
    @ParameterizedTest
    @CsvSource({"0.3, 0.7, 0.2", "0.26, 0.74, 0.2", "0.251, 0.651, 0.151"})
    void theWallsOfAClosedRoomOfTouchingBoxesHaveTheirLight(double x, double y, double z) {
        Vector lamp = new Vector(x, y, z);
        Vector eye = new Vector(0.29, 0.68, 0.16);
        picture("cam" + DrawnPicture.numbers(eye) + " 0.29 0.68 1  0 1 0  1 4", lamp, aroundTheRoom())
            .assertSolved(ROUNDING, (right, up) -> ROOM.innerWall(eye, new Vector(2 * right, 2 * up, 1))
                .map(wall -> OptionalDouble.of(wall.lightOf(lamp))).orElse(DrawnPicture.UNDECIDED));
    }

    /**
     * Where and how a solution's ball and floor lie in the world of the scene.
     *
     * @param place of the point in which they touch
     * @param normal of the floor, any length
     * @param scale length of a unit of the solution
     */
    private record Placing(Vector place, Vector normal, double scale) {
        Vector point(Vector solved) {
            return Vectors.plus(place, scale, direction(solved));
        }

        Vector direction(Vector solved) {
            Vectors.Axes basis = Vectors.around(normal.unit());
            return Vectors.plus(Vectors.plus(basis.v().times(solved.x()), solved.y(), basis.w()), solved.z(), basis.u());
        }

        String floor() {
            return "pln" + DrawnPicture.numbers(normal) + normal.dot(place) + " 1";
        }

        String ball() {
            return "sph" + DrawnPicture.numbers(point(BALL.centre())) + scale * BALL.radius() + " 1";
        }

        /** Holds the picture of these surfaces to that of a ball that touches a floor. */
        void assertBallOnFloor(double tolerance, String... surfaces) {
            String camera = "cam" + DrawnPicture.numbers(point(LOW_EYE))
                + DrawnPicture.numbers(point(Vectors.plus(LOW_EYE, new Vector(0, 0, 1))))
                + DrawnPicture.numbers(direction(new Vector(0, 1, 0))) + "1 1.2";
            picture(camera, point(BALL.lamp()), List.of(), surfaces).assertSolved(tolerance,
                (right, up) -> BALL.grey(LOW_EYE, new Vector(0.6 * right, 0.6 * up, 1), OPEN));
        }
    }

    /** However the floor is turned: the picture is solved upright, and scene and camera are turned together. */
    @ParameterizedTest
    @CsvSource({"0, 1, 0", "1, 2, 3", "1, 1.4142135623730951, -1.7320508075688772", "-0.3, 0.1, 0.2", "0, -7, 0"})
    void aBallThatTouchesAFloorHasItsShadowAndNoSpeck(double x, double y, double z) {
        Placing turned = new Placing(new Vector(1, -2, 3), new Vector(x, y, z), 0.7);
        turned.assertBallOnFloor(ROUNDING, turned.floor(), turned.ball());
    }

    /** A floor laid of cubes, their tops in one plane: neither eye nor lamp sees a joint. None is exactly in view. */
    @Test
    void aFloorOfTouchingBoxesLooksLikeAPlane() {
        Placing placing = new Placing(new Vector(0, 0.3, 0), new Vector(0, 1, 0), 0.2);
        List<String> surfaces = new ArrayList<>(List.of(placing.ball()));
        for (int column = -8; column <= 8; column++) {
            for (int row = -3; row <= 10; row++) {
                surfaces.add(new PaperBox(new Vector(0.3 * column + 0.0137, 0.15, 0.3 * row), 0.3).line(1));
            }
        }
        placing.assertBallOnFloor(ROUNDING, surfaces.toArray(String[]::new));
    }

    /**
     * The eye is 1 above the middle of a cube of edge 2, looking at the middle of an edge of its top, 45 degrees down:
     * below the middle row of the picture is the top, above it the sky, and the rays of the middle row touch the cube
     * in that edge. There they come in through the top and leave through the side in one point: what they meet is the
     * top.
     */
    @ParameterizedTest
    @CsvSource({"1, 0", "-1, 0", "0, 1", "0, -1"})
    void whereARayOnlyTouchesTheEdgeOfABoxItSeesTheFaceThroughWhichItComesIn(double x, double z) {
        Vector eye = new Vector(0, 2, 0);
        Vector lamp = new Vector(0.5, 4, 0.25);
        Vector across = new Vector(-z, 0, x);
        picture("cam 0 2 0  " + x + " 1 " + z + "  0 1 0  1 1", lamp, List.of(new PaperBox(Vector.ZERO, 2)))
            .assertSolved(ROUNDING, (right, up) -> {
                if (up > 0) {
                    return OptionalDouble.of(0.25);
                }
                Vector ahead = new Vector(x, -1, z).times(Math.sqrt(0.5));
                Vector upwards = new Vector(x, 1, z).times(Math.sqrt(0.5));
                Vector ray = Vectors.plus(Vectors.plus(ahead, -0.5 * right, across), 0.5 * up, upwards);
                Vector top = Vectors.plus(eye, -1 / ray.y(), ray);
                return OptionalDouble.of(3 / lamp.minus(top).length());
            });
    }

    /**
     * A floor at the height 0.3 under a ball, and a second surface in the same place: the same plane with another
     * normal, a cube whose top lies in it, or the same ball. Whichever comes first in the scene, the picture is that of
     * the first alone: what coincides with a surface does not shade it. A ball's light runs out where the lamp sets
     * behind it, and there a rounding of its place may decide; so the bound is 1e-6.
     */
    @ParameterizedTest
    @ValueSource(strings = {"pln 0 1 0 0.3 1", "pln 0 2 0 0.6 1", "pln 0 -1 0 -0.3 1", "pln 0 3 0 0.9 1",
        "box 0 -1.2 0 3 1", "box 0.5 -0.2 0.5 1 1", "box 0.3 0.2 -1.5 0.2 1", "sph 0 1.3 0 1 1"})
    void aSecondSurfaceInTheSamePlaceChangesNoPixel(String second) {
        Placing placing = new Placing(new Vector(0, 0.3, 0), new Vector(0, 1, 0), 1);
        placing.assertBallOnFloor(1e-6, "pln 0 1 0 0.3 1", "sph 0 1.3 0 1 1", second);
        placing.assertBallOnFloor(1e-6, second, "sph 0 1.3 0 1 1", "pln 0 1 0 0.3 1");
    }

    /** The same for a slanted floor and numbers that are no doubles. */
    @ParameterizedTest
    @ValueSource(doubles = {1, -1, 3, 0.1})
    void aSecondSlantedPlaneInTheSamePlaceChangesNoPixel(double factor) {
        Placing placing = new Placing(new Vector(0.1, 0.2, 0.3), new Vector(1, 2, 3), 1);
        Vector normal = new Vector(1, 2, 3).times(factor);
        String second = "pln" + DrawnPicture.numbers(normal) + normal.dot(placing.place()) + " 1";
        placing.assertBallOnFloor(ROUNDING, placing.floor(), placing.ball(), second);
        placing.assertBallOnFloor(ROUNDING, second, placing.ball(), placing.floor());
    }

    /**
     * Two cubes that overlap, their tops both at the height 0.3, seen from 0.06 above where both are, straight down:
     * N.L is the lamp's height above them over its distance. The last two lamps shine along the tops, at 7 and 1
     * thousandths.
     */
    @ParameterizedTest
    @CsvSource({"0.2, 2, 0.3", "0.02, 0.36, 0.01", "0.3, 0.302, 0.1", "0.5, 0.3005, 0"})
    void twoOverlappingBoxesWithTheirTopsInOnePlaneLookLikeOne(double x, double y, double z) {
        Vector lamp = new Vector(x, y, z);
        PaperBox large = new PaperBox(new Vector(0, 0.2, 0), 0.2);
        PaperBox small = new PaperBox(new Vector(0.02, 0.25, 0.01), 0.1);
        for (List<PaperBox> boxes : List.of(List.of(large, small), List.of(small, large))) {
            picture("cam 0.02 0.36 0.01  0.02 0 0.01  0 0 1  1 1", lamp, boxes)
                .assertSolved(ROUNDING, (right, up) -> {
                    Vector point = new Vector(0.02 + 0.03 * right, 0.3, 0.01 + 0.03 * up);
                    return OptionalDouble.of((y - 0.3) / lamp.minus(point).length());
                });
        }
    }

    /** A lamp of 1000 stands a thousandth of its distance above the floor: N.L is that height over its distance. */
    @ParameterizedTest
    @CsvSource({"0, 1, 0", "1, 2, 3", "1, 1.4142135623730951, -1.7320508075688772"})
    void aPlaneInGrazingLightHasNoSpeck(double x, double y, double z) {
        Placing turned = new Placing(new Vector(0.1, 0.3, -0.2), new Vector(x, y, z), 1);
        Vector lamp = new Vector(100, 0.1, 0);
        Vector eye = turned.point(new Vector(0, 1, 0));
        Vector up = turned.direction(new Vector(0, 0, 1));
        String camera = "cam" + DrawnPicture.numbers(eye) + DrawnPicture.numbers(turned.place())
            + DrawnPicture.numbers(up) + "1 2";
        String light = "lgt" + DrawnPicture.numbers(turned.point(lamp)) + "1000 1000 1000  1 1 0";
        DrawnPicture.of(camera, SKY, WHITE, turned.floor(), light).assertSolved(ROUNDING,
            (right, ahead) -> OptionalDouble.of(100 / lamp.minus(new Vector(right, 0, ahead)).length()));
    }

    /**
     * Balls around the world's origin, seen from straight above, under a lamp of 1000 so far to the right that it rises
     * or sets within the picture: of a whole ball half is day, and of a thousandth of a large one, seen from close by,
     * the evening runs through the picture, at x = -0.5. Day has N.L, night has nothing. A ray (right, -1, up) from the
     * height d meets the ball after the smaller root t of a t t - 2 d t + c = 0, with c = (d - r) (d + r).
     */
    @ParameterizedTest
    @CsvSource({"1, 3, 1e6, 0", "1, 3, 2, 0.9", "1000, 1001, 1e6, 1500"})
    void aBallInGrazingLightHasNoSpeckByDayAndNoLightByNight(double r, double d, double lampX, double lampY) {
        Vector lamp = new Vector(lampX, lampY, 0);
        DrawnPicture.of("cam 0 " + d + " 0  0 0 0  0 0 1  1 2", SKY, WHITE, "sph 0 0 0 " + r + " 1",
            "lgt" + DrawnPicture.numbers(lamp) + "1000 1000 1000  1 1 0").assertSolved(ROUNDING, (right, up) -> {
                Vector ray = new Vector(right, -1, up);
                double c = (d - r) * (d + r);
                double discriminant = d * d - ray.dot(ray) * c;
                if (Math.abs(discriminant) < 1e-3) {
                    return DrawnPicture.UNDECIDED;
                }
                if (discriminant < 0) {
                    return OptionalDouble.of(0.25);
                }
                Vector point = Vectors.plus(new Vector(0, d, 0), c / (d + Math.sqrt(discriminant)), ray);
                Vector toLamp = lamp.minus(point);
                return OptionalDouble.of(1000 * Math.max(0, point.dot(toLamp) / toLamp.length() / r));
            });
    }
}
