package raytracing.report;

import java.util.List;

/**
 * Error as a power of time: on logarithmic axes a straight line.
 *
 * @param exponent its slope, below 0 where more time buys less error
 * @param errorOfMillisecond the error that a millisecond buys
 */
record PowerLaw(double exponent, double errorOfMillisecond) {
    /** The line with the least squares of differences in the logarithm of the error; the times are not all equal. */
    static PowerLaw fitted(List<TimedError> points) {
        double meanX = points.stream().mapToDouble(PowerLaw::x).average().orElseThrow();
        double meanY = points.stream().mapToDouble(PowerLaw::y).average().orElseThrow();
        double products = points.stream().mapToDouble(point -> (x(point) - meanX) * (y(point) - meanY)).sum();
        double squares = points.stream().mapToDouble(point -> (x(point) - meanX) * (x(point) - meanX)).sum();
        double exponent = products / squares;
        return new PowerLaw(exponent, Math.exp(meanY - exponent * meanX));
    }

    private static double x(TimedError point) {
        return Math.log(point.milliseconds());
    }

    private static double y(TimedError point) {
        return Math.log(point.error());
    }

    /** When it comes down to an error. */
    double milliseconds(double error) {
        return Math.pow(error / errorOfMillisecond, 1 / exponent);
    }
}
