package raytracing.numerics;

import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import raytracing.math.Vector;
import raytracing.surface.Departure;
import raytracing.surface.Ray;
import raytracing.surface.RayOrigin;
import raytracing.surface.RayRecord;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

/** A ray and a triangle: where do they meet? The origin is exactly where it says. */
record TriangleQuery(Vector origin, Vector direction, Vector a, Vector b, Vector c) {
    private static final int NUMBER = 0;

    Triangle triangle() {
        return Triangle.of(a, b, c, 0);
    }

    Ray ray() {
        return new RayRecord(origin, 0, direction, RayOrigin.NO_SURFACE, Departure.ELSEWHERE).toRay();
    }

    /** What the product finds by doubles alone; it may leave out what is certainly beyond {@code latest}. */
    double quickCrossing(double latest) {
        return triangle().firstCrossing(ray(), latest);
    }

    /** What the product finds: by exact numbers where doubles leave it open. */
    double found() {
        double quick = quickCrossing(Surface.MISS);
        return Double.isNaN(quick) ? Surface.distance(triangle().exactCrossing(ray(), NUMBER)) : quick;
    }

    Optional<ExactCrossing> exact() {
        return ExactTriangle.between(a, b, c).firstCrossing(origin, direction);
    }

    /** Whether there is a ray and a triangle at all. */
    boolean isValid() {
        return !direction.isZero() && isFinite(origin) && isFinite(direction) && isFinite(a) && isFinite(b) && isFinite(c)
            && !ExactTriangle.between(a, b, c).isEmpty();
    }

    private static boolean isFinite(Vector v) {
        return v.largestPart() < Double.POSITIVE_INFINITY;
    }

    /** The same in other axes. */
    TriangleQuery inAxes(UnaryOperator<Vector> axes) {
        return new TriangleQuery(axes.apply(origin), axes.apply(direction), axes.apply(a), axes.apply(b), axes.apply(c));
    }

    /** With all lengths and the ray's speed in other units. */
    TriangleQuery inUnits(double lengths, double speed) {
        return new TriangleQuery(origin.times(lengths), direction.times(speed), a.times(lengths), b.times(lengths),
            c.times(lengths));
    }

    /** With its corners in another order, one of six. */
    TriangleQuery renamed(int order) {
        TriangleQuery turned = switch (order % 3) {
            case 0 -> this;
            case 1 -> new TriangleQuery(origin, direction, b, c, a);
            default -> new TriangleQuery(origin, direction, c, a, b);
        };
        return order % 6 < 3 ? turned : new TriangleQuery(origin, direction, turned.b, turned.a, turned.c);
    }

    TriangleQuery withOrigin(Vector other) {
        return new TriangleQuery(other, direction, a, b, c);
    }

    TriangleQuery withDirection(Vector other) {
        return new TriangleQuery(origin, other, a, b, c);
    }

    /** As a line of Java, in hexadecimal, so that a failure can be repeated to the last bit. */
    @Override
    public String toString() {
        return DoubleStream.of(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z(),
                a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), c.x(), c.y(), c.z())
            .mapToObj(Double::toHexString).collect(Collectors.joining(", "));
    }
}
