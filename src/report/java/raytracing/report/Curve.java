package raytracing.report;

import java.util.List;
import java.util.Optional;
import raytracing.Quantiles;

/**
 * Ever finer settings of one method of one program.
 *
 * @param title of the method
 * @param look on the plot
 * @param points from the coarsest setting to the finest
 */
record Curve(String title, Look look, List<Point> points) {
    /** It is extrapolated to errors down to this part of the smallest that was measured. */
    private static final double FARTHEST = 2;

    /** Colour, and shape of the points. */
    record Look(Ink ink, Series.Shape shape) {
    }

    /**
     * A setting.
     *
     * @param title its name on the plot
     * @param milliseconds of processor time
     * @param error against the program's own converged picture, root mean square in linear light
     * @param isBound whether it is that picture's own error, and the setting's may be less
     */
    record Point(String title, Quantiles milliseconds, double error, boolean isBound) {
        TimedError figures() {
            return new TimedError(milliseconds.median(), error);
        }
    }

    /** When it comes down to an error; nothing for one far below those that were measured. */
    Optional<EqualError.Time> at(double error) {
        double least = points.stream().mapToDouble(Point::error).min().orElseThrow();
        return error < least / FARTHEST ? Optional.empty()
            : new EqualError(points.stream().map(Point::figures).toList()).at(error);
    }
}
