package raytracing;

import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import raytracing.color.Color;
import raytracing.film.Film;

/**
 * What two films of the same size have to do with each other, in linear light. Of light above 1 no picture shows how
 * much it is, and smooth edges cut it off before they take means: it counts as 1.
 */
public final class Films {
    private static final int CHANNELS = 3;

    private Films() {
    }

    /** The mean of films, at least one. */
    public static Film mean(List<Film> films) {
        Film first = films.get(0);
        Film mean = new Film(first.width(), first.height());
        int count = films.size();
        pixels(first).forEach(i -> {
            double red = films.stream().mapToDouble(film -> at(film, i).red()).sum();
            double green = films.stream().mapToDouble(film -> at(film, i).green()).sum();
            double blue = films.stream().mapToDouble(film -> at(film, i).blue()).sum();
            mean.set(i % first.width(), i / first.width(), red / count, green / count, blue / count);
        });
        return mean;
    }

    /** A film whose pixels are the means of squares of n x n pixels, of light cut off at 1. */
    public static Film shrunk(Film film, int n) {
        Film shrunk = new Film(film.width() / n, film.height() / n);
        for (int y = 0; y < shrunk.height(); y++) {
            for (int x = 0; x < shrunk.width(); x++) {
                double red = 0;
                double green = 0;
                double blue = 0;
                for (int i = 0; i < n * n; i++) {
                    Color color = film.get(x * n + i % n, y * n + i / n);
                    red += Film.shown(color.red());
                    green += Film.shown(color.green());
                    blue += Film.shown(color.blue());
                }
                shrunk.set(x, y, red / (n * n), green / (n * n), blue / (n * n));
            }
        }
        return shrunk;
    }

    /** Root of the mean square of all differences, over all channels of all pixels. */
    public static double rootMeanSquare(Film a, Film b) {
        double squares = differences(a, b).map(difference -> difference * difference).sum();
        return Math.sqrt(squares / ((double) CHANNELS * a.width() * a.height()));
    }

    /** The largest difference of a channel of a pixel. */
    public static double largest(Film a, Film b) {
        return differences(a, b).max().orElse(0);
    }

    /** Share of the pixels that differ at all, by whatever bit. */
    public static double shareChanged(Film a, Film b) {
        return (double) pixels(a).filter(i -> !at(a, i).equals(at(b, i))).count() / (a.width() * a.height());
    }

    /** Share of the pixels of which a channel differs by more than so much. */
    public static double shareOffByMoreThan(Film a, Film b, double difference) {
        return (double) pixels(a).filter(i -> largestOfPixel(at(a, i), at(b, i)) > difference).count()
            / (a.width() * a.height());
    }

    /** The largest difference of a pixel's channels. */
    public static double largestOfPixel(Color p, Color q) {
        return differences(p, q).max().orElseThrow();
    }

    /** The sum of the squares of two pixels' differences, over their channels. */
    public static double squaredDifference(Color p, Color q) {
        return differences(p, q).map(difference -> difference * difference).sum();
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
