package raytracing.report;

import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import raytracing.color.Color;
import raytracing.film.Film;

/**
 * What two films of the same size have to do with each other, in linear light. Of light above 1 no picture shows how
 * much it is, and smooth edges cut it off before they take means: it counts as 1.
 */
final class Films {
    private static final int CHANNELS = 3;

    private Films() {
    }

    /** The film half-way between two. */
    static Film mean(Film a, Film b) {
        Film mean = new Film(a.width(), a.height());
        for (int y = 0; y < a.height(); y++) {
            for (int x = 0; x < a.width(); x++) {
                Color p = a.get(x, y);
                Color q = b.get(x, y);
                mean.set(x, y, (p.red() + q.red()) / 2, (p.green() + q.green()) / 2, (p.blue() + q.blue()) / 2);
            }
        }
        return mean;
    }

    /** Root of the mean square of all differences, over all channels of all pixels. */
    static double rootMeanSquare(Film a, Film b) {
        double squares = differences(a, b).map(difference -> difference * difference).sum();
        return Math.sqrt(squares / ((double) CHANNELS * a.width() * a.height()));
    }

    /** The largest difference of a channel of a pixel. */
    static double largest(Film a, Film b) {
        return differences(a, b).max().orElse(0);
    }

    /** Share of the pixels that differ at all, by whatever bit. */
    static double shareChanged(Film a, Film b) {
        return (double) pixels(a).filter(i -> !at(a, i).equals(at(b, i))).count() / (a.width() * a.height());
    }

    /** The largest difference of a pixel's channels. */
    static double largestOfPixel(Color p, Color q) {
        return differences(p, q).max().orElseThrow();
    }

    private static DoubleStream differences(Film a, Film b) {
        return pixels(a).mapToObj(i -> i).flatMapToDouble(i -> differences(at(a, i), at(b, i)));
    }

    private static DoubleStream differences(Color p, Color q) {
        return DoubleStream.of(difference(p.red(), q.red()), difference(p.green(), q.green()),
            difference(p.blue(), q.blue()));
    }

    private static double difference(double a, double b) {
        return Math.abs(Film.shown(a) - Film.shown(b));
    }

    private static IntStream pixels(Film film) {
        return IntStream.range(0, film.width() * film.height());
    }

    private static Color at(Film film, int pixel) {
        return film.get(pixel % film.width(), pixel / film.width());
    }
}
