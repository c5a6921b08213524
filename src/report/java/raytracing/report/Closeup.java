package raytracing.report;

import java.util.Comparator;
import java.util.stream.IntStream;
import raytracing.Films;
import raytracing.film.Film;
import raytracing.render.Region;

/**
 * The square of a picture that is farthest from its reference.
 *
 * @param place where it lies in the picture
 * @param found what the picture has there
 * @param aim what it should have there
 */
record Closeup(Region place, Film found, Film aim) {
    /** Of the square, in pixels; a smaller picture is its own close-up. */
    static final int EDGE = 32;

    /** The place with the largest root mean square, the first of several; looked for where there is a reference. */
    static Closeup of(Film found, Reference reference) {
        return IntStream.range(0, reference.blocks().size())
            .mapToObj(i -> worst(found, reference.blocks().get(i), reference.films().get(i)))
            .reduce((first, second) -> second.squares > first.squares ? second : first)
            .map(worst -> worst.closeup).orElseThrow();
    }

    /** The worst square of a block, and the sum of its squared errors. */
    private record Worst(double squares, Closeup closeup) {
    }

    private static Worst worst(Film found, Region block, Film aim) {
        Film part = found.part(block.left(), block.top(), block.width(), block.height());
        int width = Math.min(EDGE, block.width());
        int height = Math.min(EDGE, block.height());
        int across = block.width() - width + 1;
        int down = block.height() - height + 1;
        double[][] sums = sums(part, aim);
        int place = IntStream.range(0, across * down).boxed()
            .max(Comparator.comparingDouble((Integer i) -> inside(sums, i % across, i / across, width, height))
                .thenComparing(Comparator.reverseOrder())).orElseThrow();
        int left = place % across;
        int top = place / across;
        return new Worst(inside(sums, left, top, width, height), new Closeup(
            new Region(block.left() + left, block.top() + top, block.left() + left + width, block.top() + top + height),
            part.part(left, top, width, height), aim.part(left, top, width, height)));
    }

    /** The squared errors of all pixels above a row and to the left of a column. */
    private static double[][] sums(Film part, Film aim) {
        double[][] sums = new double[part.height() + 1][part.width() + 1];
        for (int y = 0; y < part.height(); y++) {
            double row = 0;
            for (int x = 0; x < part.width(); x++) {
                row += Films.squaredDifference(part.get(x, y), aim.get(x, y));
                sums[y + 1][x + 1] = sums[y][x + 1] + row;
            }
        }
        return sums;
    }

    private static double inside(double[][] sums, int left, int top, int width, int height) {
        return sums[top + height][left + width] - sums[top][left + width] - sums[top + height][left] + sums[top][left];
    }
}
