package raytracing.numerics;

import raytracing.math.Vector;
import raytracing.math.Vectors;

/** Rays and spheres. Unless it says otherwise: a unit direction, coordinates up to about 30, radius 1/2 to 4. */
public enum SphereFamily implements Family {
    ORDINARY("ordinary", new Recipe(16, RandomNumbers::line, SphereFamily::ordinary)),
    /** Origin 10^3 to 10^9 radii away. */
    FAR("far away", new Recipe(1, RandomNumbers::line, SphereFamily::far)),
    /** Radius 10^4 to 10^12, origin 10^-3 to 30 above it. */
    GROUND("ground", new Recipe(1, RandomNumbers::line, SphereFamily::ground)),
    /** Radius 10^-12 to 10^-3. */
    TINY("tiny", new Recipe(1, RandomNumbers::line, SphereFamily::tiny)),
    /** Closest approach r (1 -/+ 10^-3 to 10^-15). */
    GRAZING("grazing", new Recipe(1, RandomNumbers::line, SphereFamily::grazing)),
    /** Origin on the wall but for rounding; leaving, entering, or along it. */
    ON_THE_SURFACE("on the surface", new Recipe(1, RandomNumbers::line, SphereFamily::onTheSurface)),
    /** Origin anywhere in it, also close to the wall. */
    INSIDE("inside", new Recipe(1, RandomNumbers::line, SphereFamily::inside)),
    /** Direction 10^-60 to 10^60 long. */
    NOT_UNIT("not a unit direction", new Recipe(1, RandomNumbers::line, SphereFamily::notUnit)),
    /** Both 10^3 to 10^8 from the world's origin. */
    OFFSET("far from the world's origin", new Recipe(1, SphereFamily::farLine, SphereFamily::ordinary));

    private final String title;
    private final Recipe recipe;

    SphereFamily(String title, Recipe recipe) {
        this.title = title;
        this.recipe = recipe;
    }

    @Override
    public Shape shape() {
        return Shape.SPHERE;
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
        return new Line(Vectors.plus(line.origin(), random.magnitude(10, 27), random.direction()), line.direction());
    }

    /** A sphere that the line passes, beyond a distance from its origin, at a part of its radius from its centre. */
    private static Query passed(RandomNumbers random, Line line, double distance, double radius, double part) {
        Vector aside = random.perpendicularTo(line.direction());
        return line.with(Vectors.plus(line.at(distance), radius * part, aside), radius);
    }

    private static Query ordinary(RandomNumbers random, Line line) {
        return passed(random, line, random.between(4, 20), random.magnitude(-1, 2), random.between(0, 2));
    }

    private static Query far(RandomNumbers random, Line line) {
        double radius = random.magnitude(-1, 2);
        return passed(random, line, radius * random.magnitude(10, 30), radius, random.between(0, 1.5));
    }

    private static Query ground(RandomNumbers random, Line line) {
        double radius = random.magnitude(13, 40);
        Vector down = random.oneIn(2) ? new Vector(0, -1, 0) : random.direction();
        return line.with(Vectors.plus(line.origin(), radius + random.magnitude(-10, 5), down), radius);
    }

    private static Query tiny(RandomNumbers random, Line line) {
        return passed(random, line, random.between(1, 20), random.magnitude(-40, -10), random.between(0, 1.5));
    }

    private static Query grazing(RandomNumbers random, Line line) {
        double part = 1 + random.sign() * random.magnitude(-50, -9);
        return passed(random, line, random.between(4, 20), random.magnitude(-1, 2), part);
    }

    private static Query onTheSurface(RandomNumbers random, Line line) {
        Vector anywhere = random.direction();
        Vector alongTheWall = random.perpendicularTo(line.direction());
        Vector outward = random.oneIn(3)
            ? Vectors.plus(alongTheWall, random.sign() * random.magnitude(-50, -9), line.direction()) : anywhere;
        double radius = random.magnitude(-1, 2);
        return line.with(Vectors.plus(line.origin(), -radius, outward), radius);
    }

    private static Query inside(RandomNumbers random, Line line) {
        double radius = random.magnitude(-1, 2);
        double part = random.oneIn(2) ? random.between(0, 1) : 1 - random.magnitude(-40, -1);
        return line.with(Vectors.plus(line.origin(), radius * part, random.direction()), radius);
    }

    private static Query notUnit(RandomNumbers random, Line line) {
        return ordinary(random, line).withDirection(line.direction().times(random.magnitude(-200, 200)));
    }
}
