package raytracing.report;

import java.util.List;
import raytracing.Films;
import raytracing.film.Film;

/**
 * The picture that others are held to: the mean of two, its halves, that err independently of each other.
 *
 * @param film the mean
 * @param ownError the error that is left in it, root mean square in linear light
 * @param half what each of its halves costs and gets wrong
 */
record Reference(Film film, double ownError, TimedError half) {
    /**
     * Where two errors of the same size are independent, their difference is the square root of two times as large as
     * each, and their mean that much smaller: half the difference.
     */
    static Reference of(Film first, Film second, double millisecondsOfEach) {
        double difference = Films.rootMeanSquare(first, second);
        return new Reference(Films.mean(List.of(first, second)), difference / 2,
            new TimedError(millisecondsOfEach, difference / Math.sqrt(2)));
    }

    /**
     * Whether a distance from it says no more than that the picture is at least as good as the reference: most of the
     * distance may be the reference's own error. A reference without error leaves no such doubt.
     */
    boolean hides(double distance) {
        return ownError > 0 && distance <= Math.sqrt(2) * ownError;
    }

    /** The error of a picture at a distance: never below the reference's own, which is all that is known there. */
    double error(double distance) {
        return hides(distance) ? ownError : distance;
    }
}
