package raytracing.numerics;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Surface;

/** Rays that reach a place where surfaces meet. */
public enum JointFamily implements EncounterFamily {
    TWO_PLANES("an edge of two planes", random -> through(random, 0, touching -> planes(touching, 2))),
    PLANES("a corner of planes", random -> through(random, 0, touching -> planes(touching, 3))),
    PLANES_BUT_FOR_ULPS("the same but for ulps", random -> through(random, 2, touching -> planes(touching, 3))),
    PLANE_AND_BOX("a plane and a box", random -> through(random, 0, t -> List.of(t.plane(), t.box()))),
    BOX_ON_PLANE("a box that stands on a plane", JointFamily::boxOnPlane),
    BOXES("boxes", random -> through(random, 0, t -> List.of(t.box(), t.box()))),
    SPHERE_AND_PLANE("a sphere and planes", random -> through(random, 0, t -> List.of(t.sphere(), t.plane(), t.plane()))),
    SPHERE_AND_BOX("a sphere and a box", random -> through(random, 0, t -> List.of(t.sphere(), t.box()))),
    ANY("any surfaces", random -> through(random, 0, touching -> any(touching, 4))),
    ANY_BUT_FOR_ULPS("any surfaces but for ulps", random -> through(random, 3, touching -> any(touching, 4))),
    ROOM_OF_PLANES("a room of planes", JointFamily::roomOfPlanes),
    RING_OF_CUBES("a ring of cubes", JointFamily::ringOfCubes),
    TRIANGLES("triangles", random -> through(random, 0, touching -> triangles(touching, 4))),
    TRIANGLE_AND_ANY("triangles and any surfaces",
        random -> through(random, 0, t -> List.of(t.triangle(), t.any(), t.triangle(), t.any()))),
    FAN("triangles around a corner", random -> through(random, 0, JointFamily::fan));

    private static final List<Double> SIZES = List.of(1.0, 0.1, 1.0 / 3, 1e-9, 1e12);

    private final String title;
    private final Function<RandomNumbers, Encounter> recipe;

    JointFamily(String title, Function<RandomNumbers, Encounter> recipe) {
        this.title = title;
        this.recipe = recipe;
    }

    @Override
    public String title() {
        return title;
    }

    @Override
    public Function<RandomNumbers, Encounter> recipe() {
        return recipe;
    }

    /** What the product makes of so many encounters. */
    List<JointRule.Verdict> verdicts(long seed, int count) {
        List<Encounter> encounters = encounters(seed, count);
        return IntStream.range(0, count).parallel()
            .mapToObj(i -> JointRule.verdict(encounters.get(i), new RandomNumbers(new SplittableRandom(seed + i))))
            .toList();
    }

    /** Share of the encounters of which the product gets any answer wrong. */
    public double wrongShare(long seed, int count) {
        return (double) verdicts(seed, count).stream().filter(verdict -> !verdict.faults().isEmpty()).count() / count;
    }

    private static List<Surface> planes(Touching touching, int count) {
        return Stream.generate(touching::plane).limit(count).map(Surface.class::cast).toList();
    }

    private static List<Surface> triangles(Touching touching, int most) {
        return Stream.generate(touching::triangle).limit(touching.random().random().nextInt(2, most + 1))
            .map(Surface.class::cast).toList();
    }

    /** Their corner is the point; each shares an edge with the next. */
    private static List<Surface> fan(Touching touching) {
        RandomNumbers random = touching.random();
        List<Vector> ring = Stream.generate(() -> Vectors.plus(touching.point(), random.wholes(9).times(0.25)))
            .limit(random.random().nextInt(3, 6)).toList();
        return IntStream.range(0, ring.size()).mapToObj(i -> new TriangleQuery(touching.point(), touching.direction(),
            touching.point(), ring.get(i), ring.get((i + 1) % ring.size())).renamed(random.random().nextInt(6)))
            .filter(TriangleQuery::isValid).map(TriangleQuery::triangle).map(Surface.class::cast).toList();
    }

    private static List<Surface> any(Touching touching, int most) {
        return Stream.generate(touching::any).limit(touching.random().random().nextInt(2, most + 1)).toList();
    }

    private static Encounter through(RandomNumbers random, int ulps, Function<Touching, List<Surface>> surfaces) {
        Line line = new Line(random.eighths(8), random.oneIn(4) ? random.wholes(8).times(0.125) : random.eighths(1));
        Touching touching = new Touching(random, line.at(random.powerOfTwo(1, 6)), line.direction());
        List<Surface> exact = surfaces.apply(touching);
        return new Encounter(line.origin(), line.direction().times(random.random().nextInt(1, 8)),
            ulps == 0 ? exact : exact.stream().map(surface -> touching.besideByUlps(surface, ulps)).toList());
    }

    private static Encounter boxOnPlane(RandomNumbers random) {
        return through(random, random.oneIn(2) ? 0 : 1, touching -> {
            Box box = touching.box();
            int axis = random.axis();
            double face = Axes.part(box.centre(), axis) + random.sign() * box.edge() / 2;
            double factor = random.whole(999) / 8;
            Plane plane = new Plane(Axes.withPart(Vector.ZERO, axis, factor), face * factor, 0);
            return random.oneIn(2) ? List.of(box, plane) : List.of(plane, box);
        });
    }

    /** Looked at from its middle, along the diagonals and the space diagonals, or from beside it. */
    private static Encounter inARoom(RandomNumbers random, int axis, double third,
                                     BiFunction<Vector, Double, List<Surface>> room) {
        double half = SIZES.get(random.random().nextInt(SIZES.size()));
        Vector middle = random.oneIn(2) ? Vector.ZERO : random.wholes(99).times(0.1 * half);
        Vector direction = Axes.withPart(new Vector(random.sign(), random.sign(), random.sign()), axis, third);
        boolean beside = random.oneIn(3);
        Vector step = direction.times(random.between(0, 0.5) * half);
        return new Encounter(beside ? Vectors.plus(middle, step) : middle, direction.times(random.between(0.5, 2)),
            room.apply(middle, half));
    }

    private static Encounter roomOfPlanes(RandomNumbers random) {
        double third = random.oneIn(4) ? random.sign() : random.between(-1, 1);
        return inARoom(random, random.axis(), third, (middle, half) -> IntStream.range(0, 6).mapToObj(i -> {
            double factor = random.oneIn(2) ? 1 : random.whole(99);
            double wall = Axes.part(middle, i / 2) + (i % 2 == 0 ? half : -half);
            return (Surface) new Plane(Axes.withPart(Vector.ZERO, i / 2, factor), wall * factor, 0);
        }).toList());
    }

    /** Eight cubes around a ninth one that is left out, seen from there. */
    private static Encounter ringOfCubes(RandomNumbers random) {
        int axis = random.axis();
        return inARoom(random, axis, random.between(-0.9, 0.9), (middle, half) -> IntStream.range(0, 9)
            .filter(place -> place != 4).mapToObj(place -> cube(middle, half, axis, place)).toList());
    }

    private static Surface cube(Vector middle, double half, int axis, int place) {
        Vector row = Axes.withPart(Vector.ZERO, (axis + 1) % 3, place / 3 - 1);
        Vector step = Axes.withPart(row, (axis + 2) % 3, place % 3 - 1);
        return new Box(Vectors.plus(middle, 2 * half, step), 2 * half, 0);
    }
}
