package raytracing.numerics;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

/** Rays that meet surfaces in an order which is hard to tell. */
public enum OrderFamily implements EncounterFamily {
    COINCIDENT_PLANES("coincident planes, scaled", OrderFamily::coincidentPlanes),
    PLANE_IN_FACE("a plane in the face of a box", OrderFamily::planeInFace),
    FACES_IN_A_PLANE("boxes with faces in a plane", OrderFamily::facesInAPlane),
    PLANES("planes through a point of the ray", random -> through(random, 0, Touching::plane)),
    SPHERES("spheres through a point of the ray", random -> through(random, 0, Touching::sphere)),
    BOXES("boxes through a point of the ray", random -> through(random, 0, Touching::box)),
    ANY("any surfaces through a point of the ray", random -> through(random, 0, Touching::any)),
    ANY_BUT_FOR_AN_ULP("the same but for an ulp", random -> through(random, 1, Touching::any)),
    ANY_BUT_FOR_ULPS("the same but for 100 ulps", random -> through(random, 100, Touching::any)),
    ROUNDED("any surfaces through a rounded point", OrderFamily::rounded),
    COMMON_CIRCLE("spheres with a common circle", OrderFamily::commonCircle),
    HAIR_APART("10^-30 apart: a plane beside any surface", OrderFamily::hairApart),
    SIDEWAYS("10^-30 apart: a sphere moved sideways", OrderFamily::sideways),
    CROWD("sixty bodies through a point of the ray", OrderFamily::crowd),
    TRIANGLES("triangles through a point of the ray", random -> through(random, 0, Touching::triangle)),
    TRIANGLES_BUT_FOR_AN_ULP("the same but for an ulp", random -> through(random, 1, Touching::triangle)),
    ANY_AND_TRIANGLES("triangles and any surfaces through a point of the ray",
        random -> through(random, random.oneIn(2) ? 0 : 1, Touching::anyOrTriangle)),
    TRIANGLES_IN_FACE("triangles in a plane and in the face of a box", OrderFamily::trianglesInFace),
    MESH("triangles around a corner in a plane", OrderFamily::mesh);

    private final String title;
    private final Function<RandomNumbers, Encounter> recipe;

    OrderFamily(String title, Function<RandomNumbers, Encounter> recipe) {
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

    /** What is wrong with a ranking of so many encounters. */
    public List<String> faults(Encounter.Ranking ranking, long seed, int count) {
        return encounters(seed, count).parallelStream().flatMap(encounter -> encounter.fault(ranking).stream()).toList();
    }

    private static Encounter coincidentPlanes(RandomNumbers random) {
        Line line = random.line();
        Vector normal = random.oneIn(2) ? Axes.withPart(Vector.ZERO, random.axis(), 1) : random.wholes(99);
        double offset = random.oneIn(4) ? 0 : random.whole(999);
        List<Surface> planes = Stream.generate(() -> scaled(random, normal, offset)).limit(among(random)).toList();
        return new Encounter(line.origin(), line.direction(), planes);
    }

    private static int among(RandomNumbers random) {
        return random.oneIn(2) ? 2 : random.random().nextInt(3, 7);
    }

    private static Surface scaled(RandomNumbers random, Vector normal, double offset) {
        double factor = random.whole(999) / 8;
        Plane plane = new Plane(normal.times(factor), offset * factor, 0);
        return random.oneIn(3) ? new Touching(random, Vector.ZERO, normal).besideByUlps(plane, 1) : plane;
    }

    private static Encounter planeInFace(RandomNumbers random) {
        Line line = random.line();
        int axis = random.axis();
        Box box = new Box(random.eighths(4), random.whole(64) * 0.125, 0);
        Box solid = new Box(box.centre(), Math.abs(box.edge()), 0);
        double face = Axes.part(solid.centre(), axis) - Math.signum(Axes.part(line.direction(), axis)) * solid.edge() / 2;
        Vector target = Axes.withPart(Vectors.plus(solid.centre(), solid.edge() / 2, random.vector(0.99)), axis, face);
        Surface plane = scaled(random, Axes.withPart(Vector.ZERO, axis, 1), face);
        Vector direction = target.minus(line.origin());
        List<Surface> surfaces = random.oneIn(2) ? List.of(plane, solid) : List.of(solid, plane);
        return new Encounter(line.origin(), direction.isZero() ? line.direction() : direction, surfaces);
    }

    private static Triangle halfOfTheFace(RandomNumbers random, Box box, int axis, double face) {
        double half = box.edge() / 2;
        Vector sideways = Axes.withPart(new Vector(random.sign(), random.sign(), random.sign()).times(half), axis, 0);
        Vector a = Axes.withPart(Vectors.plus(box.centre(), sideways), axis, face);
        Vector b = mirrored(a, box.centre(), (axis + 1) % 3);
        Vector c = mirrored(a, box.centre(), (axis + 2) % 3);
        Triangle triangle = new TriangleQuery(a, a, a, b, c).renamed(random.random().nextInt(6)).triangle();
        return random.oneIn(4) ? (Triangle) new Touching(random, a, a).besideByUlps(triangle, 1) : triangle;
    }

    private static Vector mirrored(Vector point, Vector centre, int axis) {
        return Axes.withPart(point, axis, 2 * Axes.part(centre, axis) - Axes.part(point, axis));
    }

    /** Halves of a box's face, in front of it by their place in the scene or behind it; seen at about the box's middle. */
    private static Encounter trianglesInFace(RandomNumbers random) {
        Encounter planeAndBox = planeInFace(random);
        Box box = (Box) planeAndBox.surfaces().stream().filter(Box.class::isInstance).findFirst().orElseThrow();
        Plane plane = (Plane) planeAndBox.surfaces().stream().filter(Plane.class::isInstance).findFirst().orElseThrow();
        int axis = plane.normal().x() != 0 ? 0 : plane.normal().y() != 0 ? 1 : 2;
        double face = plane.offset() / Axes.part(plane.normal(), axis);
        List<Surface> surfaces = new ArrayList<>(Stream.generate(() -> halfOfTheFace(random, box, axis, face))
            .limit(among(random)).toList());
        surfaces.add(random.random().nextInt(surfaces.size() + 1), box);
        surfaces.add(random.random().nextInt(surfaces.size() + 1), plane);
        return new Encounter(planeAndBox.origin(), planeAndBox.direction(), surfaces);
    }

    /** The ray goes to the corner, or to a point of an edge or of a triangle. */
    private static Encounter mesh(RandomNumbers random) {
        Vector middle = random.eighths(8);
        Vector u = random.wholes(9).times(0.125);
        Vector v = random.wholes(9).times(0.25);
        if (u.cross(v).isZero()) {
            return mesh(random);
        }
        List<Vector> ring = List.of(Vectors.plus(middle, u), Vectors.plus(middle, v), Vectors.plus(middle, -1, u),
            Vectors.plus(middle, -1, v));
        Vector target = Vectors.plus(Vectors.plus(middle, random.random().nextInt(3) / 4.0, u),
            random.random().nextInt(3) / 4.0, v);
        List<Surface> surfaces = IntStream.range(0, 8).mapToObj(i -> new TriangleQuery(u, v, middle, ring.get(i % 4),
            ring.get((i + 1) % 4)).renamed(random.random().nextInt(6)).triangle()).map(Surface.class::cast).toList();
        Vector origin = random.oneIn(2) ? random.eighths(20) : random.vector(20);
        return new Encounter(origin, target.minus(origin), surfaces);
    }

    private static Encounter facesInAPlane(RandomNumbers random) {
        Line line = random.line();
        int axis = random.axis();
        double towards = Math.signum(Axes.part(line.direction(), axis));
        double face = random.whole(80) / (random.oneIn(2) ? 8 : 10);
        Vector target = line.at((face - Axes.part(line.origin(), axis)) / Axes.part(line.direction(), axis));
        List<Surface> boxes = IntStream.range(0, among(random)).mapToObj(i -> {
            double edge = random.random().nextInt(1, 80) / (random.oneIn(2) ? 8.0 : 10.0);
            Vector centre = Vectors.plus(target, edge / 2, random.vector(0.99));
            return (Surface) new Box(Axes.withPart(centre, axis, face + towards * edge / 2), edge, 0);
        }).toList();
        return new Encounter(line.origin(), line.direction(), boxes);
    }

    /** A ray through a point without an error. */
    private static Line roundLine(RandomNumbers random) {
        Vector few = random.oneIn(4) ? random.wholes(8).times(0.125) : random.eighths(1);
        return new Line(random.eighths(8), random.oneIn(2) ? few : random.wholes(1 << 26).times(0x1p-26));
    }

    /**
     * The ray's direction is a whole multiple of the line's, so that hardly any crossing is a double; a large one, so
     * that its products round.
     */
    private static Touching touching(RandomNumbers random, Line line) {
        double multiple = random.random().nextInt(1, random.oneIn(2) ? 8 : 1 << 20);
        return new Touching(random, line.at(random.powerOfTwo(1, 7)), line.direction().times(multiple));
    }

    private static Encounter through(RandomNumbers random, int ulps, Function<Touching, Surface> surface) {
        Line line = roundLine(random);
        Touching touching = touching(random, line);
        return new Encounter(line.origin(), touching.direction(), IntStream.range(0, among(random)).mapToObj(i -> {
            Surface exact = surface.apply(touching);
            return ulps == 0 ? exact : touching.besideByUlps(exact, ulps);
        }).toList());
    }

    private static Encounter rounded(RandomNumbers random) {
        Line line = random.line();
        Vector point = line.at(random.between(1, 20));
        Touching touching = new Touching(random, point, line.direction());
        List<Surface> surfaces = Stream.generate(() -> roundedThrough(touching)).limit(among(random)).toList();
        return new Encounter(line.origin(), line.direction(), surfaces);
    }

    private static Surface roundedThrough(Touching touching) {
        RandomNumbers random = touching.random();
        Vector normal = random.direction();
        double radius = random.between(0.5, 4);
        return random.oneIn(3) ? new Plane(normal, normal.dot(touching.point()), 0)
            : random.oneIn(2) ? new Sphere(Vectors.plus(touching.point(), radius, normal), radius, 0) : touching.box();
    }

    /**
     * Whole spheres around the points of a line that stands on the ray at a right angle: both roots of the first are
     * roots of all the others, though no double tells them. Every other one has an ulp more or less.
     */
    private static Encounter commonCircle(RandomNumbers random) {
        Vector direction = random.wholes(5);
        Vector aside = Pythagorean.perpendicularTo(direction, random);
        Vector origin = random.wholes(40);
        Vector centre = Vectors.plus(Vectors.plus(origin, random.random().nextInt(2, 20), direction), random.wholes(9));
        double radius = random.random().nextInt(9, 30);
        List<Sphere> spheres = IntStream.rangeClosed(-40, 40).boxed()
            .flatMap(i -> withCircle(origin, centre, radius, Vectors.plus(centre, i, aside)).stream()).toList();
        if (spheres.size() < 2) {
            return commonCircle(random);
        }
        Touching touching = new Touching(random, origin, direction);
        List<Surface> some = Stream.generate(() -> spheres.get(random.random().nextInt(spheres.size())))
            .map(sphere -> random.oneIn(4) ? touching.besideByUlps(sphere, 1) : sphere)
            .limit(among(random)).toList();
        return new Encounter(origin, direction, some);
    }

    private static Optional<Sphere> withCircle(Vector origin, Vector centre, double radius, Vector other) {
        Vector way = origin.minus(centre);
        Vector otherWay = origin.minus(other);
        double square = radius * radius + otherWay.dot(otherWay) - way.dot(way);
        double otherRadius = Math.sqrt(Math.max(0, square));
        return square > 0 && otherRadius == Math.rint(otherRadius)
            ? Optional.of(new Sphere(other, otherRadius, 0)) : Optional.empty();
    }

    /** A plane across an axis, whose crossing is the fraction closest to that of another surface. */
    private static Encounter hairApart(RandomNumbers random) {
        int axis = random.axis();
        Vector origin = Axes.withPart(random.vector(10), axis, 0);
        Vector direction = Axes.withPart(random.vector(1), axis, random.sign());
        Surface surface = new Touching(random, Vectors.plus(origin, random.between(1, 20), direction), direction).any();
        Optional<ExactCrossing> crossing = ExactCrossing.first(surface, origin, direction);
        if (crossing.isEmpty()) {
            return hairApart(random);
        }
        BigDecimal t = crossing.get().value();
        ClosestFraction closest = ClosestFraction.to(t);
        Vector normal = Axes.withPart(Vector.ZERO, axis, closest.denominator());
        Surface plane = new Plane(normal, closest.numerator() * Axes.part(direction, axis), 0);
        return new Encounter(origin, direction, random.oneIn(2) ? List.of(plane, surface) : List.of(surface, plane));
    }

    /** A step at a right angle to ray and radius changes a crossing by half its square: 2^-100 and less. */
    private static Encounter sideways(RandomNumbers random) {
        Line line = new Line(Axes.withPart(random.eighths(8), 1, 0), Axes.withPart(random.eighths(1), 1, 0));
        Vector point = line.at(random.powerOfTwo(1, 6));
        double size = random.powerOfTwo(-2, 2);
        Vector towardsCentre = new Vector(3 * Math.signum(line.direction().x()), 0, 4 * Math.signum(line.direction().z()));
        Vector centre = Vectors.plus(point, size, towardsCentre);
        Sphere sphere = new Sphere(centre, 5 * size, 0);
        Vector step = new Vector(0, random.sign() * random.magnitude(-55, -48), 0);
        Sphere moved = new Sphere(Vectors.plus(centre, step), 5 * size, 0);
        Touching touching = new Touching(random, point, line.direction());
        Surface other = random.oneIn(2) ? sphere : touching.any();
        return new Encounter(line.origin(), line.direction(),
            random.oneIn(2) ? List.of(moved, other) : List.of(other, moved));
    }

    private static Encounter crowd(RandomNumbers random) {
        Line line = roundLine(random);
        Touching touching = touching(random, line);
        boolean spheres = random.oneIn(2);
        int rest = random.random().nextInt(4);
        return new Encounter(line.origin(), touching.direction(), IntStream.range(0, 60 + rest).mapToObj(i -> {
            Surface exact = i >= 60 ? touching.any() : spheres ? touching.sphere() : touching.box();
            return random.oneIn(3) ? touching.besideByUlps(exact, 2) : exact;
        }).toList());
    }
}
