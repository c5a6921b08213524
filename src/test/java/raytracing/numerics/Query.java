package raytracing.numerics;

import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/**
 * A ray and a surface: where do they first meet? The shape is known from where the query comes.
 *
 * @param origin of the ray
 * @param direction of the ray, of any length but 0
 * @param vector centre of the sphere or box, normal of the plane
 * @param scalar radius, edge or offset
 */
public record Query(Vector origin, Vector direction, Vector vector, double scalar) {
    /** The same query in other axes. */
    public Query inAxes(UnaryOperator<Vector> axes) {
        return new Query(axes.apply(origin), axes.apply(direction), axes.apply(vector), scalar);
    }

    static Query of(double ox, double oy, double oz, double dx, double dy, double dz,
                    double x, double y, double z, double scalar) {
        return new Query(new Vector(ox, oy, oz), new Vector(dx, dy, dz), new Vector(x, y, z), scalar);
    }

    /** The rest of the ray from o + t d on, rounded. */
    public Query startingAt(double t) {
        return new Query(Vectors.plus(origin, t, direction), direction, vector, scalar);
    }

    /** The same line, run through at another speed. */
    public Query withDirection(Vector other) {
        return new Query(origin, other, vector, scalar);
    }

    /** The same ray to another place. */
    public Query withVector(Vector other) {
        return new Query(origin, direction, other, scalar);
    }

    /** With all lengths and the ray's speed in other units; of a sphere or a box. */
    Query inUnits(double lengths, double speed) {
        return new Query(origin.times(lengths), direction.times(speed), vector.times(lengths), scalar * lengths);
    }

    /** As a line of Java, in hexadecimal, so that a failure can be repeated to the last bit. */
    @Override
    public String toString() {
        return DoubleStream.of(origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z(),
                vector.x(), vector.y(), vector.z(), scalar)
            .mapToObj(Double::toHexString).collect(Collectors.joining(", ", "Query.of(", ")"));
    }
}
