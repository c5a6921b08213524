package raytracing.numerics;

import raytracing.math.Vector;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;

/** Where points lie that are so far off a surface that doubles can tell. */
final class Sides {
    private Sides() {
    }

    /**
     * How far a point is from a surface: above 0 outside a body and below 0 inside; of a plane, above 0 where the
     * normal points to.
     */
    static double height(Surface surface, Vector point) {
        if (surface instanceof Plane plane) {
            return (plane.normal().dot(point) - plane.offset()) / plane.normal().length();
        }
        if (surface instanceof Sphere sphere) {
            return point.minus(sphere.centre()).length() - sphere.radius();
        }
        Box box = (Box) surface;
        return point.minus(box.centre()).largestPart() - box.edge() / 2;
    }

    /** What the rounding of a height is measured by: the lengths that it is a difference of. */
    static double size(Surface surface, Vector point) {
        if (surface instanceof Plane plane) {
            return point.length() + Math.abs(plane.offset()) / plane.normal().length();
        }
        return surface instanceof Sphere sphere ? point.length() + sphere.centre().length() + sphere.radius()
            : point.length() + ((Box) surface).centre().length() + ((Box) surface).edge();
    }

    /** Whether a point is further from a surface than a share of the lengths that are compared. */
    static boolean isOff(Surface surface, Vector point, double share) {
        return Math.abs(height(surface, point)) > share * size(surface, point);
    }
}
