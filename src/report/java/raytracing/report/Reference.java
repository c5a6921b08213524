package raytracing.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import raytracing.Films;
import raytracing.film.Film;
import raytracing.render.Region;

/**
 * The picture that others are held to: the mean of two, its halves, that err independently of each other.
 *
 * @param blocks the parts of the picture that it has, all of the same size
 * @param films the mean in each of these parts
 * @param ownError the error that is left in it, root mean square in linear light
 * @param half what each of its halves costs and gets wrong; the cost of a whole picture
 */
record Reference(List<Region> blocks, List<Film> films, double ownError, TimedError half) {
    /** Of whole pictures. */
    static Reference of(Film first, Film second, double millisecondsOfEach) {
        return of(List.of(Region.whole(first.width(), first.height())), List.of(first), List.of(second),
            millisecondsOfEach);
    }

    /**
     * Where two errors of the same size are independent, their difference is the square root of two times as large as
     * each, and their mean that much smaller: half the difference.
     */
    static Reference of(List<Region> blocks, List<Film> firsts, List<Film> seconds, double millisecondsOfEach) {
        List<Film> means = new ArrayList<>();
        double squares = 0;
        for (int i = 0; i < blocks.size(); i++) {
            double difference = Films.rootMeanSquare(firsts.get(i), seconds.get(i));
            squares += difference * difference;
            means.add(Films.mean(List.of(firsts.get(i), seconds.get(i))));
        }
        double difference = Math.sqrt(squares / blocks.size());
        return new Reference(blocks, means, difference / 2,
            new TimedError(millisecondsOfEach, difference / Math.sqrt(2)));
    }

    /** The whole picture, if it has it. */
    Optional<Film> whole() {
        return blocks.get(0).left() == 0 ? Optional.of(films.get(0)) : Optional.empty();
    }

    /** How many pixels it has. */
    long pixels() {
        return blocks.stream().mapToLong(Region::pixelCount).sum();
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
