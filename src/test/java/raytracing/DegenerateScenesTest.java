package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.scene.Scene;

/**
 * Scenes that are in order and yet at the edge of what formulas mean: lamps and eyes exactly on surfaces, things in one
 * place, views along axes, colours beyond measure. What lies on a surface is on both sides of it: a surface neither
 * hides nor shades what it contains, and gets no light from a lamp in its own plane. "Exactly" is meant as it is
 * written in decimals; in doubles such a point is beside the surface by a rounding.
 */
class DegenerateScenesTest {
    private static final double ROUNDING = 1e-9;
    private static final double OPEN = 1e-6;
    private static final String WHITE = "mtl 1 1 1  0 0 0  0 0 0  1 0";
    private static final String BLACK = "mtl 0 0 0  0 0 0  0 0 0  1 0";
    private static final String SHINY = "mtl 0 0 0  1 1 1  0 0 0  2 0";
    private static final String SKY = "set 0.25 0.25 0.25  1 1";
    private static final Vector X = new Vector(1, 0, 0);
    private static final Vector Y = new Vector(0, 1, 0);
    private static final Vector Z = new Vector(0, 0, 1);
    private static final String AHEAD = "cam 0 0 0  0 0 1  0 1 0  1 2";

    /** A ball beside a cube with a ball on it, before the eye. */
    private static final List<String> BODIES = List.of(
        "pln 0 1 0 -1 1", "sph -0.7 -0.2 4 0.8 1", "box 0.8 -0.5 3.5 1 1", "sph 0.9 0.5 3.2 0.5 1");

    private static DrawnPicture picture(List<String> surfaces, String... others) {
        List<String> lines = new ArrayList<>(List.of(SKY, WHITE, BLACK, SHINY));
        lines.addAll(surfaces);
        lines.addAll(List.of(others));
        return DrawnPicture.of(lines.toArray(String[]::new));
    }

    private static String camera(Vector eye, Vector view, Vector up, double width) {
        return "cam" + DrawnPicture.numbers(eye) + DrawnPicture.numbers(Vectors.plus(eye, view)) + DrawnPicture.numbers(up)
            + "1 " + width;
    }

    private static String lamp(Vector position) {
        return "lgt" + DrawnPicture.numbers(position) + "1 1 1  1 1 0";
    }

    private static Vector vector(String numbers) {
        String[] parts = numbers.trim().split(" +");
        return new Vector(Double.parseDouble(parts[0]), Double.parseDouble(parts[1]), Double.parseDouble(parts[2]));
    }

    /** N.L, or 0 where the lamp is behind; the normal is of length 1. */
    private static double lightOn(Vector point, Vector normal, Vector lamp) {
        return Math.max(0, normal.dot(lamp.minus(point)) / lamp.minus(point).length());
    }

    /** From inside a ball: the place on its wall at which a line from anywhere inside arrives. */
    private static Vector wallOfBall(Vector centre, double radius, Vector from, Vector direction) {
        Vector w = direction.unit();
        Vector start = from.minus(centre);
        double foot = -start.dot(w);
        double missedBy = start.cross(w).length();
        return Vectors.plus(from, foot + Math.sqrt((radius - missedBy) * (radius + missedBy)), w);
    }

    /**
     * A ball of radius 5, seen from inside, is divided by a plane, and the lamp lies in that plane: it lights the wall
     * of both halves, and the plane, which it sees edge-on, not at all: neither a matte one (material 1) nor a shiny
     * one (3), whose highlights end where N.L does.
     */
    @ParameterizedTest(name = "{0} = {1} with a lamp at {2}, material {3}")
    @CsvSource({
        "0 1 0,          0.25, 0.5 0.25 1,  1",
        "0 1 0,          0.3,  0.1 0.3 0.2, 1",
        "0 1 0,          0.3,  0.1 0.3 0.2, 3",
        "0 3 0,          0.9,  0.1 0.3 0.2, 1",
        "0 0 -0.1,      -0.02, 0.1 0.3 0.2, 1",
        "1 2 3,          2,    0.25 0.5 0.25, 1",
        "1 2 3,          1.4,  0.1 0.2 0.3, 1",
        "-1 -2 -3,      -1.4,  0.1 0.2 0.3, 1",
        "0.1 0.2 0.3,    0.14, 0.1 0.2 0.3, 1",
        "1 2 3,          1.4,  0.1 0.2 0.3, 3",
    })
    void aLampInAPlaneLightsTheRoomOnBothSidesAndNotThePlane(String normal, double offset, String lamp, int material) {
        Vector light = vector(lamp);
        Vectors.Axes frame = Vectors.around(vector(normal).unit());
        for (double side : List.of(1.0, -1.0)) {
            Vector up = frame.w().times(side);
            Vector right = frame.v().times(side);
            Vector eye = Vectors.plus(light, up).minus(frame.u());
            picture(List.of("sph 0 0 0 5 1", "pln " + normal + " " + offset + " " + material), lamp(light),
                camera(eye, frame.u(), up, 2)).assertSolved(ROUNDING, (x, y) -> {
                    Vector ray = Vectors.plus(Vectors.plus(frame.u(), x, right), y, up);
                    Vector wall = wallOfBall(Vector.ZERO, 5, eye, ray);
                    double above = wall.minus(light).dot(up);
                    if (Math.abs(above) < OPEN) {
                        return DrawnPicture.UNDECIDED;
                    }
                    return OptionalDouble.of(above < 0 ? 0 : lightOn(wall, wall.times(-0.2), light));
                });
        }
    }

    /**
     * From inside a ball with the lamp L on its wall. The triangle of centre C, L and P on the wall has two sides r, so
     * its third side meets both radii at the same angle, whose cosine is |L - P| / (2 r): that is N.L.
     */
    @ParameterizedTest(name = "{0}, {1}, lamp {2}")
    @CsvSource({"0 0 0, 5, 3 -4 0", "0.1 0.2 0.3, 1, 0.7 -0.6 0.3", "0.1 0.2 0.3, 0.7, 0.3 0.5 0.9"})
    void aLampOnABallLightsAllItsInside(String centre, double radius, String lamp) {
        Vector light = vector(lamp);
        picture(List.of("sph " + centre + " " + radius + " 1"), lamp(light), camera(vector(centre), X, Y, 4))
            .assertSolved(ROUNDING, (right, up) -> {
                Vector wall = Vectors.plus(vector(centre), radius, new Vector(1, 2 * up, -2 * right).unit());
                return OptionalDouble.of(light.minus(wall).length() / (2 * radius));
            });
    }

    /**
     * The same lamp on the outside, at C + r (3/5, -4/5, 0), over a floor 2 r below C. The ball is convex: it hides the
     * lamp from all that is below the plane that touches it there, and from nothing above. On the floor that plane is
     * at (x - L.x) 3/5 = (y - L.y) 4/5 with y - L.y = -6/5 r, so x = L.x - 8/5 r. The ball itself sees nothing of its
     * lamp. The eye is 3 r above C and 1.5 r aside, looking down.
     */
    @ParameterizedTest(name = "{0}, {1}, lamp {2}")
    @CsvSource({"0 0 0, 5, 3 -4 0", "0.1 0.2 0.3, 1, 0.7 -0.6 0.3"})
    void aLampOnABallLightsWhatIsOnItsSideOfTheTangentPlane(String centre, double radius, String lamp) {
        Vector light = vector(lamp);
        Vector middle = vector(centre);
        Vector eye = Vectors.plus(middle, radius, new Vector(1.5, 3, 0));
        picture(List.of("sph " + centre + " " + radius + " 1", "pln 0 1 0 " + (middle.y() - 2 * radius) + " 1"),
            lamp(light), camera(eye, Vectors.negated(Y), Z, 2)).assertSolved(ROUNDING, (right, up) -> {
                Vector ray = new Vector(right, -1, up);
                Vector floor = Vectors.plus(eye, 5 * radius, ray);
                double missedBy = middle.minus(eye).cross(ray.unit()).length();
                double edge = floor.x() - (light.x() - 1.6 * radius);
                if (Math.abs(missedBy - radius) < OPEN || Math.abs(edge) < OPEN) {
                    return DrawnPicture.UNDECIDED;
                }
                boolean isDark = missedBy < radius || edge < 0;
                return OptionalDouble.of(isDark ? 0 : lightOn(floor, Y, light));
            });
    }

    /** A lamp on the wall x = c + e/2 of a cube that is seen from inside lights its other five walls. */
    @ParameterizedTest(name = "{0}, {1}, lamp {2}")
    @CsvSource({"0 0 0, 2, 1 0.25 0.5", "0.1 0.2 0.3, 0.6, 0.4 0.25 0.35", "0.7 0.7 0.7, 0.3, 0.85 0.75 0.6"})
    void aLampOnAFaceOfABoxLightsTheOtherFacesFromInside(String centre, double edge, String lamp) {
        Vector light = vector(lamp);
        PaperBox box = new PaperBox(vector(centre), edge);
        Vector eye = Vectors.plus(vector(centre), edge, new Vector(0.1, -0.2, 0.05));
        picture(List.of(box.line(1)), lamp(light), camera(eye, X, Y, 4))
            .assertSolved(ROUNDING, (right, up) -> box.innerWall(eye, new Vector(1, 2 * up, -2 * right))
                .map(wall -> OptionalDouble.of(wall.lightOf(light))).orElse(DrawnPicture.UNDECIDED));
    }

    /**
     * The same lamp lights, of a floor 3/2 e below the cube's middle, what is beyond the plane of its face: x above
     * L.x. From 5/2 e above the middle the eye sees, but for that floor, the cube's top, above the lamp and so dark.
     */
    @ParameterizedTest(name = "{0}, {1}, lamp {2}")
    @CsvSource({"0 0 0, 2, 1 0.25 0.5", "0.1 0.2 0.3, 0.6, 0.4 0.25 0.35", "0.7 0.7 0.7, 0.3, 0.85 0.75 0.6"})
    void aLampOnAFaceOfABoxLightsWhatIsOnItsSideOfTheFace(String centre, double edge, String lamp) {
        Vector light = vector(lamp);
        PaperBox box = new PaperBox(vector(centre), edge);
        Vector eye = Vectors.plus(vector(centre), edge, new Vector(0, 2.5, 0));
        picture(List.of(box.line(1), "pln 0 1 0 " + (vector(centre).y() - 1.5 * edge) + " 1"), lamp(light),
            camera(eye, Vectors.negated(Y), Z, 2)).assertSolved(ROUNDING, (right, up) -> {
                Vector floor = Vectors.plus(eye, 4 * edge, new Vector(right, -1, up));
                if (box.isMetBetween(eye, floor).isEmpty() || Math.abs(floor.x() - light.x()) < OPEN) {
                    return DrawnPicture.UNDECIDED;
                }
                boolean isDark = box.isMetBetween(eye, floor).get() || floor.x() < light.x();
                return OptionalDouble.of(isDark ? 0 : lightOn(floor, Y, light));
            });
    }

    /** A ball rests on a floor with the lamp in it: sky above the horizon, and all else is dark. */
    @Test
    void aLampInABallLightsNothingOutside() {
        picture(List.of("pln 0 1 0 -1 1", "sph 0 0 3 1 1"), AHEAD, lamp(new Vector(0.3, -0.4, 3.1)))
            .assertSolved(0, (right, up) -> {
                double missedBy = 3 * Math.sqrt(1 - 1 / (1 + right * right + up * up));
                if (Math.abs(missedBy - 1) < OPEN) {
                    return DrawnPicture.UNDECIDED;
                }
                return OptionalDouble.of(missedBy < 1 || up < 0 ? 0 : 0.25);
            });
    }

    @Test
    void aLampInABallLightsAllItsInside() {
        Vector light = new Vector(0.3, -0.4, 0.1);
        Vector eye = new Vector(0.2, 0.5, -0.6);
        picture(List.of("sph 0 0 0 1 1"), lamp(light), camera(eye, Z, Y, 4))
            .assertSolved(ROUNDING, (right, up) -> {
                Vector wall = wallOfBall(Vector.ZERO, 1, eye, new Vector(2 * right, 2 * up, 1));
                return OptionalDouble.of(lightOn(wall, Vectors.negated(wall), light));
            });
    }

    /** A rule: a lamp at the eye lights all that the eye sees. */
    @Test
    void aLampAtTheEyeThrowsNoShadowThatIsSeen() {
        picture(BODIES, AHEAD, "lgt 0 0 0  1 1 1  1 1 0").assertLike(
            picture(BODIES, AHEAD, "lgt 0 0 0  1 1 1  1 0 0"), 0);
    }

    /** The lamp casts no shadows here, so a plane that is not seen has no part in the picture. */
    @ParameterizedTest(name = "{0} = {1} with an eye at {2}")
    @CsvSource({"0 1 0, 0, 0 0 0", "0 1 0, 0.3, 0.1 0.3 0.2", "0 3 0, 0.9, 0.1 0.3 0.2", "1 2 3, 2, 0.25 0.5 0.25",
        "1 2 3, 1.4, 0.1 0.2 0.3", "-1 -2 -3, -1.4, 0.1 0.2 0.3"})
    void aPlaneThroughTheEyeIsNotSeen(String normal, double offset, String eye) {
        String[] others = {camera(vector(eye), Z, Y, 2), "lgt 3 4 0  1 1 1  1 0 0"};
        List<String> surfaces = new ArrayList<>(BODIES);
        surfaces.add("pln " + normal + " " + offset + " 2");
        picture(surfaces, others).assertLike(picture(BODIES, others), 0);
    }

    /**
     * The eye E on a ball, looking along its wall: outwards it sees the sky, inwards the far wall. E lies on the ball,
     * so a ray along the unit vector w meets it again at the distance 2 (C - E).w.
     */
    @ParameterizedTest(name = "{0}, {1}, eye {2}")
    @CsvSource({"0 0 0, 5, 3 4 0", "0.1 0.2 0.3, 1, 0.7 1.0 0.3", "0.1 0.2 0.3, 1, -0.5 -0.6 0.3"})
    void anEyeOnABallSeesItsFarWallOrNothingOfIt(String centre, double radius, String eye) {
        Vector middle = vector(centre);
        Vector start = vector(eye);
        Vector light = Vectors.plus(middle, radius, new Vector(0.2, -0.1, 0.3));
        picture(List.of("sph " + centre + " " + radius + " 1"), lamp(light),
            camera(start, Z, Y, 2)).assertSolved(ROUNDING, (right, up) -> {
                Vector w = new Vector(right, up, 1).unit();
                double across = 2 * middle.minus(start).dot(w);
                if (Math.abs(across) < OPEN) {
                    return DrawnPicture.UNDECIDED;
                }
                Vector wall = Vectors.plus(start, across, w);
                Vector inwards = middle.minus(wall).times(1 / radius);
                return OptionalDouble.of(across < 0 ? 0.25 : lightOn(wall, inwards, light));
            });
    }

    /** The eye on the face z = c - e/2, looking along it: to the left the sky, to the right the far walls. */
    @ParameterizedTest(name = "{0}, {1}, eye {2}")
    @CsvSource({"0 0 0, 2, 0 0.25 -1", "0.1 0.2 0.3, 0.6, 0.1 0.3 0", "0.7 0.7 0.7, 0.3, 0.7 0.65 0.55",
        "0.55 0.55 0.55, 0.3, 0.5 0.6 0.4"})
    void anEyeOnAFaceOfABoxSeesItsFarWallsOrNothingOfIt(String centre, double edge, String eye) {
        PaperBox box = new PaperBox(vector(centre), edge);
        Vector light = Vectors.plus(box.centre(), edge, new Vector(0.2, -0.1, 0.3));
        picture(List.of(box.line(1)), lamp(light), camera(vector(eye), Vectors.negated(X), Y, 2))
            .assertSolved(ROUNDING, (right, up) -> {
                if (Math.abs(right) < OPEN) {
                    return DrawnPicture.UNDECIDED;
                }
                if (right < 0) {
                    return OptionalDouble.of(0.25);
                }
                return box.innerWall(vector(eye), new Vector(-1, up, right))
                    .map(wall -> OptionalDouble.of(wall.lightOf(light))).orElse(DrawnPicture.UNDECIDED);
            });
    }

    /** White before black in the same place is white, black before white is black: the second has no part in it. */
    @ParameterizedTest(name = "{0} and {1}")
    @CsvSource({
        "pln 0 1 0 -0.3,      pln 0 1 0 -0.3",
        "pln 0 1 0 -0.3,      pln 0 4 0 -1.2",
        "pln 0 1 0 -0.3,      pln 0 -1 0 0.3",
        "pln 1 2 -3 -1.4,     pln 1 2 -3 -1.4",
        "pln 1 2 -3 -1.4,     pln -2 -4 6 2.8",
        "sph 0.1 0.2 3 0.7,   sph 0.1 0.2 3 0.7",
        "box 0.1 0.2 3 0.7,   box 0.1 0.2 3 0.7",
        "pln 0 1 0 -0.5,      box 0 -1 3 1",
        "box 0 -1 3 1,        box 0.25 -0.75 3 0.5",
    })
    void ofCoincidentSurfacesTheFirstIsSeen(String first, String second) {
        String light = "lgt 2 3 -1  1 1 1  1 1 0";
        List<String> wall = List.of("pln 0 0 1 9 1");
        for (List<String> materials : List.of(List.of(" 1", " 2"), List.of(" 2", " 1"))) {
            List<String> alone = new ArrayList<>(wall);
            alone.add(first + materials.get(0));
            List<String> both = new ArrayList<>(alone);
            both.add(second + materials.get(1));
            picture(both, AHEAD, light).assertLike(picture(alone, AHEAD, light), OPEN);
        }
    }

    @Test
    void twoLampsInOnePlaceGiveTwiceTheLight() {
        picture(BODIES, AHEAD, "lgt 3 4 0  1 1 1  1 1 0", "lgt 3 4 0  1 1 1  1 1 0").assertLike(
            picture(BODIES, AHEAD, "lgt 3 4 0  2 2 2  1 1 0"), 0);
    }

    /** A law: turned so that the view runs along another axis, the scene looks the same. */
    @ParameterizedTest(name = "{0}")
    @ValueSource(strings = {"+x", "-x", "+y", "-y", "-z"})
    void alongEveryAxisTheViewIsTheSame(String axis) {
        List<String> lines = new ArrayList<>(List.of(SKY, WHITE, AHEAD, "lgt 3 4 0  1 1 1  1 1 0"));
        lines.addAll(BODIES);
        Scene scene = SceneText.scene(lines.toArray(String[]::new));
        Scene turned = Motion.about(point -> turned(point, axis)).moved(scene);
        DrawnPicture.of(turned).assertLike(DrawnPicture.of(scene), ROUNDING);
    }

    /** Turns of the world that take +z to the axis. */
    private static Vector turned(Vector point, String axis) {
        return switch (axis) {
            case "+x" -> new Vector(point.z(), point.x(), point.y());
            case "-x" -> new Vector(-point.z(), point.y(), point.x());
            case "+y" -> new Vector(point.y(), point.z(), point.x());
            case "-y" -> new Vector(point.x(), -point.z(), point.y());
            default -> new Vector(-point.x(), point.y(), -point.z());
        };
    }

    /** White where there is any light at all, black where there is none, whether lamp or surfaces are so bright. */
    @ParameterizedTest(name = "lamp {0}, surfaces {1}")
    @CsvSource({"1e300, 1", "1, 1e300", "1e300, 1e300"})
    void hugeColoursAreWhiteWhereThereIsLight(String lamp, String surface) {
        DrawnPicture ordinary = coloured("1", "1");
        DrawnPicture huge = coloured(lamp, surface);
        int white = 0;
        for (int i = 0; i < DrawnPicture.SIZE * DrawnPicture.SIZE; i++) {
            double light = ordinary.get(i % DrawnPicture.SIZE, i / DrawnPicture.SIZE).green();
            double found = Math.min(1, huge.get(i % DrawnPicture.SIZE, i / DrawnPicture.SIZE).green());
            assertEquals(light > 0 ? 1 : 0, found, "pixel " + i);
            white += found == 1 ? 1 : 0;
        }
        assertTrue(white > 100, "too few to mean anything: " + white);
    }

    @ParameterizedTest(name = "lamp {0}, surfaces {1}")
    @CsvSource({"1e-300, 1", "1, 1e-300", "1e-300, 1e-300"})
    void tinyColoursAreBlack(String lamp, String surface) {
        DrawnPicture tiny = coloured(lamp, surface);
        for (int i = 0; i < DrawnPicture.SIZE * DrawnPicture.SIZE; i++) {
            assertEquals(0, tiny.get(i % DrawnPicture.SIZE, i / DrawnPicture.SIZE).green(), 1e-290, "pixel " + i);
        }
    }

    /** 10^300 times 10^-300 is 1. */
    @Test
    void aHugeLampOnTinyColoursIsAnOrdinaryOneOnOrdinaryOnes() {
        List<String> tiny = List.of("mtl 1e-300 1e-300 1e-300  0 0 0  0 0 0  1 0", "pln 0 1 0 -1 4", "sph 0 0 4 1 4");
        List<String> ordinary = List.of("pln 0 1 0 -1 1", "sph 0 0 4 1 1");
        picture(tiny, AHEAD, "lgt 3 4 0  1e300 1e300 1e300  1 1 0").assertLike(
            picture(ordinary, AHEAD, "lgt 3 4 0  1 1 1  1 1 0"), ROUNDING);
    }

    /** The bodies before a black sky; diffuse, specular and mirrored light are all of one colour. */
    private static DrawnPicture coloured(String lamp, String surface) {
        String color = " " + surface + " " + surface + " " + surface + " ";
        List<String> lines = new ArrayList<>(List.of("set 0 0 0 1 5", "mtl " + color + color + color + " 10 0.5", AHEAD,
            "lgt 3 4 0  " + lamp + " " + lamp + " " + lamp + "  1 1 0"));
        lines.addAll(BODIES);
        return DrawnPicture.of(lines.toArray(String[]::new));
    }
}
