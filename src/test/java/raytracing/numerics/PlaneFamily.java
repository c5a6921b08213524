package raytracing.numerics;

import raytracing.math.Vector;
import raytracing.math.Vectors;

/** Rays and planes. Unless it says otherwise: a unit direction, a unit normal, coordinates up to about 30. */
public enum PlaneFamily implements Family {
    ORDINARY("ordinary", new Recipe(16, RandomNumbers::line, PlaneFamily::ordinary)),
    /** N . d down to 10^-300, and 0. */
    PARALLEL("nearly parallel", new Recipe(1, RandomNumbers::line, PlaneFamily::parallel)),
    /** Normal 10^-6 to 10^6 long. */
    SCALED("not a unit normal", new Recipe(1, RandomNumbers::line, PlaneFamily::scaled)),
    /** Both 10^3 to 10^9 from the world's origin. */
    OFFSET("far from the world's origin", new Recipe(1, PlaneFamily::farLine, PlaneFamily::ordinary)),
    /** Origin on it but for rounding. */
    ON_THE_PLANE("on the plane", new Recipe(1, RandomNumbers::line, PlaneFamily::onThePlane)),
    /** Origin 10^-15 to 10^-3 off it. */
    NEAR("near the plane", new Recipe(1, RandomNumbers::line, PlaneFamily::near));

    private final String title;
    private final Recipe recipe;

    PlaneFamily(String title, Recipe recipe) {
        this.title = title;
        this.recipe = recipe;
    }

    @Override
    public Shape shape() {
        return Shape.PLANE;
    }

    @Override
    public String title() {
        return title;
    }

    @Override
    public Recipe recipe() {
        return recipe;
    }

    private static Line farLine(RandomNumbers random) {
        Line line = random.line();
        return new Line(Vectors.plus(line.origin(), random.magnitude(10, 30), random.direction()), line.direction());
    }

    private static Query through(Vector point, Vector normal, Line line) {
        return line.with(normal, normal.dot(point));
    }

    private static Query ordinary(RandomNumbers random, Line line) {
        return through(line.at(random.sign() * random.between(1, 20)), random.direction(), line);
    }

    /** Either along an axis, where N . d is one product and can be as small as a double can, or at any angle. */
    private static Query parallel(RandomNumbers random, Line line) {
        int axis = random.axis();
        Vector normal = random.oneIn(2) ? Axes.withPart(Vector.ZERO, axis, random.sign() * random.magnitude(-1, 1))
            : random.perpendicularTo(line.direction());
        double smallPart = random.oneIn(8) ? random.zero() : random.sign() * random.magnitude(-1000, -10);
        return through(random.vector(10), normal, line).withDirection(
            Axes.withPart(line.direction(), axis, smallPart));
    }

    private static Query scaled(RandomNumbers random, Line line) {
        Vector normal = random.direction().times(random.magnitude(-20, 20));
        return through(line.at(random.sign() * random.between(1, 20)), normal, line);
    }

    private static Query onThePlane(RandomNumbers random, Line line) {
        return through(line.origin(), random.direction(), line);
    }

    private static Query near(RandomNumbers random, Line line) {
        Vector normal = random.direction();
        double height = random.sign() * random.magnitude(-50, -9);
        return line.with(normal, normal.dot(line.origin()) + height);
    }
}
