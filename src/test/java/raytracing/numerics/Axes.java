package raytracing.numerics;

import java.util.List;
import java.util.function.UnaryOperator;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/** The parts of a vector by number: 0 is x, 1 is y, 2 is z. And the changes of axes that change no answer. */
final class Axes {
    /** All orders of the axes but the given one. */
    static final List<UnaryOperator<Vector>> PERMUTATIONS = List.of(
        v -> new Vector(v.x(), v.z(), v.y()), v -> new Vector(v.y(), v.x(), v.z()),
        v -> new Vector(v.z(), v.y(), v.x()), v -> new Vector(v.y(), v.z(), v.x()),
        v -> new Vector(v.z(), v.x(), v.y()));

    /** One, two or three axes mirrored. */
    static final List<UnaryOperator<Vector>> MIRRORS = List.of(
        v -> new Vector(-v.x(), v.y(), v.z()), v -> new Vector(v.x(), -v.y(), v.z()),
        v -> new Vector(v.x(), v.y(), -v.z()), v -> new Vector(-v.x(), -v.y(), v.z()),
        v -> new Vector(-v.x(), v.y(), -v.z()), v -> new Vector(v.x(), -v.y(), -v.z()), Vectors::negated);

    private Axes() {
    }

    static double part(Vector v, int axis) {
        return switch (axis) {
            case 0 -> v.x();
            case 1 -> v.y();
            default -> v.z();
        };
    }

    static Vector withPart(Vector v, int axis, double part) {
        return switch (axis) {
            case 0 -> new Vector(part, v.y(), v.z());
            case 1 -> new Vector(v.x(), part, v.z());
            default -> new Vector(v.x(), v.y(), part);
        };
    }
}
