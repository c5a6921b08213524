package raytracing.numerics;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

/**
 * How a point that a ray has reached lies to one surface: in front of it, on the side from which the ray came. From
 * that follows which lines from the point cross the surface and which rays meet it at once. Where a line or a ray runs
 * so nearly along the surface that the answer depends on roundings, there is none.
 *
 * @param isHigh whether the ray came from outside a body, or from where a normal of a plane or triangle points to
 * @param normals unit normals of the surface at the point, outward: one, or on a box's edge two or three; none if the
 *        point is well off the surface
 * @param inwards of a triangle, for each edge at the point: the unit vector from the edge to the triangle's side
 * @param back the unit vector to where the ray came from
 */
record JointSide(Surface surface, boolean isHigh, List<Vector> normals, List<Vector> inwards, Vector back) {
    /** The sine of the angle from which on a direction leads away from a surface for certain. */
    static final double CLEAR = 0x1p-4;

    /**
     * What is nearer is at the point, as a share of the lengths that are compared. A mirrored ray goes up to 1 / CLEAR
     * times as far to what is at the point, and so may the next one from there.
     */
    static final double NEAR = 0x1p-40;

    /** A ray that meets something so near meets it at once. */
    static final double AT_ONCE = 0x1p-26;

    /** What is further away is well off, for certain rays and lines as well. */
    static final double WELL_OFF = 0x1p-20;

    /**
     * The side of a point that is a ray's first crossing; if the ray runs nearly along the surface there, none is
     * known.
     */
    static Optional<JointSide> of(Surface surface, Encounter encounter, Vector point) {
        Vector back = encounter.origin().minus(point).unit();
        if (Sides.isOff(surface, point, WELL_OFF)) {
            return Optional.of(new JointSide(surface, Sides.height(surface, point) > 0, List.of(), List.of(), back));
        }
        if (Sides.isOff(surface, point, NEAR) || surface instanceof Triangle triangle && isNextToAnEdge(triangle, point)) {
            return Optional.empty();
        }
        List<Vector> normals = normals(surface, point);
        boolean isHigh = Sides.height(surface, encounter.origin()) > 0;
        return Optional.of(new JointSide(surface, isHigh, normals, inwards(surface, point), back))
            .filter(side -> side.isReachedBy(encounter.origin(), encounter.direction().unit()));
    }

    /** Neither at it nor well off it. */
    private static boolean isNextToAnEdge(Triangle triangle, Vector point) {
        double size = Sides.size(triangle, point);
        return IntStream.range(0, 3).mapToDouble(edge -> Math.abs(Sides.inside(triangle, edge, point)) / size)
            .anyMatch(distance -> distance > NEAR && distance <= WELL_OFF);
    }

    private static List<Vector> inwards(Surface surface, Vector point) {
        return surface instanceof Triangle triangle ? IntStream.range(0, 3)
            .filter(edge -> Math.abs(Sides.inside(triangle, edge, point)) <= WELL_OFF * Sides.size(triangle, point))
            .mapToObj(edge -> Sides.inward(triangle, edge)).toList() : List.of();
    }

    private static List<Vector> normals(Surface surface, Vector point) {
        if (surface instanceof Plane plane) {
            return List.of(plane.normal().unit());
        }
        if (surface instanceof Triangle triangle) {
            return List.of(Sides.normal(triangle));
        }
        return surface instanceof Sphere sphere ? List.of(point.minus(sphere.centre()).unit())
            : faces((Box) surface, point).toList();
    }

    /** Outward normals of the faces in whose planes a point of a box lies. */
    private static Stream<Vector> faces(Box box, Vector point) {
        Vector fromCentre = point.minus(box.centre());
        return IntStream.range(0, 3).boxed()
            .filter(axis -> Math.abs(Math.abs(Axes.part(fromCentre, axis)) - box.edge() / 2)
                <= WELL_OFF * Sides.size(box, point))
            .map(axis -> Axes.withPart(Vector.ZERO, axis, Math.signum(Axes.part(fromCentre, axis))));
    }

    /**
     * From outside a box, it is enough that the ray comes from in front of one of the faces: the box lies behind that
     * one.
     */
    private boolean isReachedBy(Vector origin, Vector direction) {
        if (isHigh && surface instanceof Box box) {
            return normals.stream().allMatch(normal -> Math.abs(normal.dot(direction)) > CLEAR)
                && normals.stream().anyMatch(normal -> normal.dot(direction) < 0 && isInFrontOf(box, normal, origin));
        }
        return goesThrough(direction, !isHigh).orElse(false);
    }

    private static boolean isInFrontOf(Box box, Vector normal, Vector point) {
        return normal.dot(point.minus(box.centre())) - box.edge() / 2 > WELL_OFF * Sides.size(box, point);
    }

    /**
     * Whether a unit direction leads through the surface where the point is: up out of a body, or down into it. On an
     * edge of a box, a direction that leads up from one face and down from another is not clear for a point outside: it
     * may be in front of either.
     *
     * @return nothing if that is not clear
     */
    private Optional<Boolean> goesThrough(Vector direction, boolean upwards) {
        double most = normals.stream().mapToDouble(normal -> normal.dot(direction)).max().orElseThrow();
        double least = normals.stream().mapToDouble(normal -> normal.dot(direction)).min().orElseThrow();
        if (most < -CLEAR) {
            return Optional.of(!upwards);
        }
        return (upwards ? most : least) > CLEAR ? Optional.of(upwards) : Optional.empty();
    }

    /** Whether a ray from the point along a unit direction meets the surface at once; nothing if that is not clear. */
    Optional<Boolean> isMetAtOnceBy(Vector direction) {
        if (normals.isEmpty()) {
            return Optional.of(false);
        }
        Optional<Boolean> goes = goesThrough(direction, !isHigh);
        return goes.equals(Optional.of(true)) ? staysInside(direction) : goes;
    }

    /**
     * Whether a line through a triangle's plane goes through the triangle, if the point is moved by next to nothing to where
     * the ray came from; nothing if that is not clear.
     */
    private Optional<Boolean> staysInside(Vector direction) {
        if (inwards.isEmpty()) {
            return Optional.of(true);
        }
        Vector normal = normals.get(0);
        Vector onPlane = Vectors.plus(back.times(1 / Math.abs(normal.dot(back))), 1 / Math.abs(normal.dot(direction)),
            direction);
        double most = CLEAR * onPlane.length();
        if (onPlane.length() < CLEAR || inwards.stream().anyMatch(inward -> Math.abs(inward.dot(onPlane)) < most)) {
            return Optional.empty();
        }
        return Optional.of(inwards.stream().allMatch(inward -> inward.dot(onPlane) > 0));
    }

    private Optional<Boolean> isCrossedBetween(Triangle triangle, Vector point, Vector end) {
        if (normals.isEmpty()) {
            return Optional.of(ExactTriangle.of(triangle).isCrossed(point, end));
        }
        double height = Sides.height(triangle, end);
        if (Math.abs(height) <= WELL_OFF * Sides.size(triangle, end)) {
            return Optional.empty();
        }
        return isHigh == height > 0 ? Optional.of(false) : staysInside(end.minus(point).unit());
    }

    /**
     * Whether the line from the point to one well off the surface crosses the surface; nothing if that is not clear.
     */
    Optional<Boolean> isCrossedBetween(Vector point, Vector end) {
        if (surface instanceof Triangle triangle) {
            return isCrossedBetween(triangle, point, end);
        }
        boolean endsHigh = Sides.height(surface, end) > 0;
        if (surface instanceof Plane || !isHigh || !endsHigh) {
            return Optional.of(isHigh != endsHigh);
        }
        Vector direction = end.minus(point).unit();
        return normals.isEmpty() ? Optional.empty() : goesThrough(direction, false);
    }
}
