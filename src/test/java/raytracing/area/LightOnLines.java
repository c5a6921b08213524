package raytracing.area;

import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * The light that comes to the apex (0, 0, 0) from a square around (0, 0, depth), by elementary geometry: the square is
 * read on fine lines of constant y, each line is parted wherever the outline of an obstacle may cross it, and one point
 * of each part decides. No area formula and no conic is used.
 */
final class LightOnLines {
    private final double depth;
    private final double halfWidth;

    /** What can hide points of the plane from the apex. */
    interface Obstacle {
        /** The share of light from (x, y, depth) that comes through. */
        double passing(double x, double y);

        /** All places on a line where that may change, and perhaps others. */
        double[] changes(double y);
    }

    /** The lines of a figure: those with a x + b y + c &gt;= 0 are on its inner side. */
    record Line(double a, double b, double c) {
        boolean hasInside(double x, double y) {
            return a * x + b * y + c >= 0;
        }

        double placeAt(double y) {
            return -(b * y + c) / a;
        }
    }

    LightOnLines(double depth, double halfWidth) {
        this.depth = depth;
        this.halfWidth = halfWidth;
    }

    /**
     * The ball around m with radius r hides a point if the way there comes nearer to m than r. From an apex in the
     * ball, or on it, the way stays in the ball, or leaves it and is hidden.
     */
    final class Ball implements Obstacle {
        private final double mx;
        private final double my;
        private final double mz;
        private final double r;
        private final double transmittance;

        Ball(double mx, double my, double mz, double r, double transmittance) {
            this.mx = mx;
            this.my = my;
            this.mz = mz;
            this.r = r;
            this.transmittance = transmittance;
        }

        @Override
        public double passing(double x, double y) {
            boolean startsOutside = mx * mx + my * my + mz * mz > r * r;
            double along = (mx * x + my * y + mz * depth) / (x * x + y * y + depth * depth);
            double nearest = Math.max(0, Math.min(along, 1));
            boolean endsInside = isInside(x, y, depth);
            boolean isHidden = startsOutside ? isInside(nearest * x, nearest * y, nearest * depth) : !endsInside;
            return isHidden ? transmittance : 1;
        }

        private boolean isInside(double x, double y, double z) {
            return (x - mx) * (x - mx) + (y - my) * (y - my) + (z - mz) * (z - mz) < r * r;
        }

        /** In the plane of the line and the apex, the ball is a disc: the ends of its chord, and its tangents. */
        @Override
        public double[] changes(double y) {
            double height = Math.hypot(y, depth);
            double up = (my * y + mz * depth) / height;
            double aside = (my * depth - mz * y) / height;
            double discRadius = Math.sqrt(r * r - aside * aside);
            double half = Math.sqrt(discRadius * discRadius - (height - up) * (height - up));
            double middle = Math.atan2(mx, up);
            double opening = Math.asin(discRadius / Math.hypot(mx, up));
            return new double[] {mx - half, mx + half, placeOf(middle - opening, height),
                placeOf(middle + opening, height)};
        }

        /** Where a ray meets the line; not at all if it goes away from it. */
        private static double placeOf(double angle, double height) {
            double turned = angle < -Math.PI ? angle + 2 * Math.PI : angle > Math.PI ? angle - 2 * Math.PI : angle;
            return Math.abs(turned) < Math.PI / 2 ? height * Math.tan(turned) : Double.NaN;
        }
    }

    /** Passes differently in a figure and around it. */
    record Figure(double inside, double outside, List<Line> lines) implements Obstacle {
        @Override
        public double passing(double x, double y) {
            return lines.stream().allMatch(line -> line.hasInside(x, y)) ? inside : outside;
        }

        @Override
        public double[] changes(double y) {
            return lines.stream().mapToDouble(line -> line.placeAt(y)).toArray();
        }
    }

    /** An obstacle that counts on the inner side of a line only. */
    record Gated(Line gate, Obstacle obstacle) implements Obstacle {
        @Override
        public double passing(double x, double y) {
            return gate.hasInside(x, y) ? obstacle.passing(x, y) : 1;
        }

        @Override
        public double[] changes(double y) {
            double[] all = Arrays.copyOf(obstacle.changes(y), obstacle.changes(y).length + 1);
            all[all.length - 1] = gate.placeAt(y);
            return all;
        }
    }

    /** The mean over the square of what passes all obstacles, by so many lines. */
    double share(int lines, List<Obstacle> obstacles) {
        DoubleUnaryOperator light = y -> lightOfLine(y, obstacles);
        return IntStream.range(0, lines).mapToDouble(i -> halfWidth * ((2 * i + 1.0) / lines - 1)).map(light).sum()
            / (2 * halfWidth * lines);
    }

    /** The integral over the line. */
    double lightOfLine(double y, List<Obstacle> obstacles) {
        double[] places = Stream.concat(Stream.of(new double[] {-halfWidth, halfWidth}),
                obstacles.stream().map(obstacle -> obstacle.changes(y)))
            .flatMapToDouble(Arrays::stream).filter(x -> Math.abs(x) <= halfWidth).sorted().toArray();
        double sum = 0;
        for (int i = 1; i < places.length; i++) {
            double x = (places[i - 1] + places[i]) / 2;
            double passing = 1;
            for (Obstacle obstacle : obstacles) {
                passing *= obstacle.passing(x, y);
            }
            sum += passing * (places[i] - places[i - 1]);
        }
        return sum;
    }
}
