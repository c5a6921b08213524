package raytracing;

import java.util.Optional;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/**
 * A cube along the axes, on paper. A straight line is inside it while it is between all three pairs of faces. Two
 * cubes decide whether it ever is, one a little smaller and one a little larger: where they agree, rounding does not matter,
 * and the rest is left open.
 *
 * @param centre its middle
 * @param edge length of an edge
 */
record PaperBox(Vector centre, double edge) {
    /** By how much of its edge the two cubes are smaller and larger. */
    private static final double OPEN = 1e-7;

    /** The scene line of this cube with a material. */
    String line(int material) {
        return "box" + DrawnPicture.numbers(centre) + edge + " " + material;
    }

    /** Whether a straight line from one point to another meets the cube; empty close to its outline. */
    Optional<Boolean> isMetBetween(Vector from, Vector to) {
        boolean meetsSmaller = new PaperBox(centre, edge * (1 - OPEN)).meets(from, to);
        boolean meetsLarger = new PaperBox(centre, edge * (1 + OPEN)).meets(from, to);
        return meetsSmaller == meetsLarger ? Optional.of(meetsLarger) : Optional.empty();
    }

    /**
     * The wall that is seen from inside.
     *
     * @param point the place on it
     * @param normal its unit normal, turned inwards
     */
    record Wall(Vector point, Vector normal) {
        /** N.L, or 0 where the lamp is behind. */
        double lightOf(Vector lamp) {
            return Math.max(0, normal.dot(lamp.minus(point)) / lamp.minus(point).length());
        }
    }

    /** What is seen from a point inside or on a face: the first face ahead; empty close to an edge. */
    Optional<Wall> innerWall(Vector from, Vector direction) {
        Vector start = from.minus(centre);
        double x = exit(start.x(), direction.x());
        double y = exit(start.y(), direction.y());
        double z = exit(start.z(), direction.z());
        double first = Math.min(x, Math.min(y, z));
        double second = Math.max(Math.min(x, y), Math.min(Math.max(x, y), z));
        if (second - first < OPEN * edge) {
            return Optional.empty();
        }
        Vector normal = x == first ? new Vector(-Math.signum(direction.x()), 0, 0)
            : y == first ? new Vector(0, -Math.signum(direction.y()), 0)
            : new Vector(0, 0, -Math.signum(direction.z()));
        return Optional.of(new Wall(Vectors.plus(from, first, direction), normal));
    }

    private double exit(double start, double way) {
        return way == 0 ? Double.POSITIVE_INFINITY : (Math.copySign(edge / 2, way) - start) / way;
    }

    private boolean meets(Vector from, Vector to) {
        Vector start = from.minus(centre);
        Vector way = to.minus(from);
        double[] starts = {start.x(), start.y(), start.z()};
        double[] ways = {way.x(), way.y(), way.z()};
        double enter = 0;
        double exit = 1;
        for (int axis = 0; axis < 3; axis++) {
            if (ways[axis] == 0) {
                exit = Math.abs(starts[axis]) <= edge / 2 ? exit : -1;
            } else {
                double low = (-edge / 2 - starts[axis]) / ways[axis];
                double high = (edge / 2 - starts[axis]) / ways[axis];
                enter = Math.max(enter, Math.min(low, high));
                exit = Math.min(exit, Math.max(low, high));
            }
        }
        return enter <= exit;
    }
}
