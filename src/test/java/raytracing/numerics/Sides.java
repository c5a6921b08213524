package raytracing.numerics;

import java.util.stream.IntStream;
import raytracing.math.Vector;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

/** Where points lie that are so far off a surface that doubles can tell. */
final class Sides {
    private Sides() {
    }

    /**
     * How far a point is from a surface: above 0 outside a body and below 0 inside; of a plane, and of the plane of a
     * triangle, above 0 where the normal points to.
     */
    static double height(Surface surface, Vector point) {
        if (surface instanceof Plane plane) {
            return (plane.normal().dot(point) - plane.offset()) / plane.normal().length();
        }
        if (surface instanceof Sphere sphere) {
            return point.minus(sphere.centre()).length() - sphere.radius();
        }
        if (surface instanceof Triangle triangle) {
            return normal(triangle).dot(point.minus(triangle.a()));
        }
        Box box = (Box) surface;
        return point.minus(box.centre()).largestPart() - box.edge() / 2;
    }

    /** The unit normal (b - a) x (c - a). */
    static Vector normal(Triangle triangle) {
        return triangle.b().minus(triangle.a()).cross(triangle.c().minus(triangle.a())).unit();
    }

    /** How far the plane's point nearest to a point is from an edge, from 0 to 2; above 0 on the triangle's side. */
    static double inside(Triangle triangle, int edge, Vector point) {
        return inward(triangle, edge).dot(point.minus(corner(triangle, edge)));
    }

    /** In the plane, the unit vector from an edge to the triangle's side. */
    static Vector inward(Triangle triangle, int edge) {
        Vector along = corner(triangle, (edge + 1) % 3).minus(corner(triangle, edge));
        return normal(triangle).cross(along).unit();
    }

    private static Vector corner(Triangle triangle, int number) {
        return new Vector(triangle.x(number), triangle.y(number), triangle.z(number));
    }

    /** What the rounding of a height is measured by: the lengths that it is a difference of. */
    static double size(Surface surface, Vector point) {
        if (surface instanceof Plane plane) {
            return point.length() + Math.abs(plane.offset()) / plane.normal().length();
        }
        if (surface instanceof Triangle triangle) {
            return point.length() + triangle.largestPart();
        }
        return surface instanceof Sphere sphere ? point.length() + sphere.centre().length() + sphere.radius()
            : point.length() + ((Box) surface).centre().length() + ((Box) surface).edge();
    }

    /** Whether a point is further from a surface than a share of the lengths that are compared. */
    static boolean isOff(Surface surface, Vector point, double share) {
        double off = share * size(surface, point);
        return Math.abs(height(surface, point)) > off || surface instanceof Triangle triangle
            && IntStream.range(0, 3).anyMatch(edge -> inside(triangle, edge, point) < -off);
    }
}
