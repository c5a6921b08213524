package raytracing.numerics;

import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

/**
 * Surfaces through a point without any rounding, as long as its parts are up to a thousand and have no digit below
 * 2^-27.
 */
record Touching(RandomNumbers random, Vector point, Vector direction) {
    Surface any() {
        return switch (random.random().nextInt(3)) {
            case 0 -> plane();
            case 1 -> sphere();
            default -> box();
        };
    }

    Plane plane() {
        Vector normal = random.wholes(random.oneIn(2) ? 9 : 1 << 12);
        return normal.dot(direction) == 0 ? plane() : new Plane(normal, normal.dot(point), 0);
    }

    /** Most of them are met from outside at the point. */
    Sphere sphere() {
        Vector whole = Pythagorean.vector(random);
        double size = random.powerOfTwo(-2, 2);
        boolean turn = whole.dot(direction) < 0 != random.oneIn(5);
        Vector towardsCentre = whole.times(turn ? -size : size);
        return new Sphere(Vectors.plus(point, towardsCentre), size * whole.length(), 0);
    }

    /** The point is a corner, or on an edge, or on a face. Most of them are met from outside there. */
    Box box() {
        double half = random.powerOfTwo(-2, 4);
        boolean fromOutside = !random.oneIn(5);
        Vector corner = new Vector(side(direction.x(), fromOutside), side(direction.y(), fromOutside),
            side(direction.z(), fromOutside)).times(half);
        int first = random.axis();
        Vector edge = random.oneIn(3) ? corner : Axes.withPart(corner, first, random.whole(7) * half / 8);
        Vector face = random.oneIn(3) ? edge : Axes.withPart(edge, (first + 1) % 3, random.whole(7) * half / 8);
        return new Box(Vectors.plus(point, face), 2 * half, 0);
    }

    /** The point is a corner, or on an edge, or inside; the ray is not in its plane. */
    Triangle triangle() {
        Vector first = random.wholes(9).times(random.powerOfTwo(-3, 2));
        Vector second = random.wholes(9).times(random.powerOfTwo(-3, 2));
        if (first.cross(second).dot(direction) == 0) {
            return triangle();
        }
        double weight = random.random().nextInt(1, 4);
        Vector third = switch (random.random().nextInt(3)) {
            case 0 -> Vector.ZERO;
            case 1 -> first.times(-weight);
            default -> Vectors.plus(first.times(-weight), -random.random().nextInt(1, 4), second);
        };
        return new TriangleQuery(point, direction, Vectors.plus(point, first), Vectors.plus(point, second),
            Vectors.plus(point, third)).renamed(random.random().nextInt(6)).triangle();
    }

    /** A triangle, or two times in three any surface. */
    Surface anyOrTriangle() {
        return random.oneIn(3) ? triangle() : any();
    }

    private double side(double part, boolean fromOutside) {
        return part == 0 ? random.sign() : fromOutside ? Math.signum(part) : -Math.signum(part);
    }

    /** The same surface, but for some units in the last place of one of its numbers. */
    Surface besideByUlps(Surface surface, int ulps) {
        boolean scalar = random.oneIn(2);
        if (surface instanceof Plane plane) {
            return scalar ? new Plane(plane.normal(), random.beside(plane.offset(), ulps), 0)
                : new Plane(random.beside(plane.normal(), ulps), plane.offset(), 0);
        }
        if (surface instanceof Sphere sphere) {
            return scalar ? new Sphere(sphere.centre(), random.beside(sphere.radius(), ulps), 0)
                : new Sphere(random.beside(sphere.centre(), ulps), sphere.radius(), 0);
        }
        if (surface instanceof Triangle triangle) {
            return scalar ? Triangle.of(random.beside(triangle.a(), ulps), triangle.b(), triangle.c(), 0)
                : Triangle.of(triangle.a(), random.beside(triangle.b(), ulps), triangle.c(), 0);
        }
        Box box = (Box) surface;
        return scalar ? new Box(box.centre(), random.beside(box.edge(), ulps), 0)
            : new Box(random.beside(box.centre(), ulps), box.edge(), 0);
    }
}
