package raytracing.render;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import raytracing.film.Film;

/**
 * Pictures drawn under an {@link ErrorLimit}, held to the truth: how large the errors are of the pixels whose rays differ,
 * and what the program says that they are. Not thread-safe.
 */
public final class ErrorCheck {
    static final double MOST_BEYOND_TWICE = 0.02;
    static final double MOST_BEYOND_FOUR_TIMES = 0.001;
    static final double LEAST_PRINTED = 0.5;
    static final double MOST_PRINTED = 2;
    private static final int OUTLIERS = 8;

    private final double limit;
    private final ErrorTally printed = new ErrorTally();
    private long drawn;
    private long pixels;
    private double squares;
    private long beyondTwice;
    private long beyondFourTimes;

    /** Of no picture yet, for a limit in steps. */
    public ErrorCheck(double limit) {
        this.limit = limit;
    }

    /** Draws a picture under the limit and adds its pixels; returns those that are most wrong, the worst first. */
    public List<Outlier> add(Renderer renderer, TrueLight truth) {
        Renderer limited = Renderers.withSampling(renderer, new ErrorLimit(limit));
        Drawing drawing = new Drawing(limited, new Cancellation(), Cancellation.Leftovers.DISCARD, DrawingListener.NONE);
        Film film = drawing.band(0);
        printed.add(drawing.errors());
        drawn += (long) truth.width() * truth.height();
        List<Outlier> outliers = new ArrayList<>();
        for (int y = 0; y < truth.height(); y++) {
            for (int x = 0; x < truth.width(); x++) {
                if (truth.isVaried(x, y)) {
                    double square = truth.squaredError(x, y, film.get(x, y));
                    add(square);
                    outliers.add(new Outlier(limited, x, y, Math.sqrt(Math.max(0, square))));
                }
            }
        }
        outliers.sort(Comparator.comparingDouble(Outlier::error).reversed());
        return outliers.subList(0, Math.min(OUTLIERS, outliers.size()));
    }

    private void add(double square) {
        pixels++;
        squares += square;
        beyondTwice += square > 4 * limit * limit ? 1 : 0;
        beyondFourTimes += square > 16 * limit * limit ? 1 : 0;
    }

    /** Adds all pictures of another check for the same limit. */
    public void add(ErrorCheck other) {
        drawn += other.drawn;
        pixels += other.pixels;
        squares += other.squares;
        beyondTwice += other.beyondTwice;
        beyondFourTimes += other.beyondFourTimes;
        printed.add(other.printed);
    }

    /** Steps. */
    public double limit() {
        return limit;
    }

    /** How many pixels have rays that differ. */
    public long pixels() {
        return pixels;
    }

    /** Root of the mean square of their errors, in steps. */
    public double trueError() {
        return pixels == 0 ? 0 : Math.sqrt(Math.max(0, squares / pixels));
    }

    /** What the program says about that, in steps. */
    public double printedError() {
        return printed.error();
    }

    /** What it says over what is true; 1 if no pixel is wrong and it says so. */
    public double printedOverTrue() {
        return printedError() == trueError() ? 1 : printedError() / trueError();
    }

    /** Share of the pixels with errors beyond twice the limit, from 0 to 1. */
    public double shareBeyondTwice() {
        return pixels == 0 ? 0 : (double) beyondTwice / pixels;
    }

    /** Share of the pixels with errors beyond four times the limit, from 0 to 1. */
    public double shareBeyondFourTimes() {
        return pixels == 0 ? 0 : (double) beyondFourTimes / pixels;
    }

    /** Rays for each pixel of the pictures, in the mean. */
    public double raysEach() {
        return drawn == 0 ? 0 : 1 + (double) printed.furtherRays() / drawn;
    }

    /** Which bounds do not hold, in the words of the table; empty if all do. */
    public List<String> failures() {
        List<String> failures = new ArrayList<>();
        if (trueError() > limit) {
            failures.add("RMS");
        }
        if (shareBeyondTwice() > MOST_BEYOND_TWICE) {
            failures.add("2 E");
        }
        if (shareBeyondFourTimes() > MOST_BEYOND_FOUR_TIMES) {
            failures.add("4 E");
        }
        if (printedOverTrue() < LEAST_PRINTED || printedOverTrue() > MOST_PRINTED) {
            failures.add("printed");
        }
        return failures;
    }

    /** All figures in one line. */
    @Override
    public String toString() {
        return String.format(Locale.ROOT, "E = %s: %d pixels vary, RMS %.3f, printed %.3f (%.2f), %.2f %% beyond 2 E, "
            + "%.3f %% beyond 4 E, %.2f rays each%s", limit, pixels, trueError(), printedError(), printedOverTrue(),
            100 * shareBeyondTwice(), 100 * shareBeyondFourTimes(), raysEach(),
            failures().isEmpty() ? "" : failures().stream().collect(Collectors.joining(", ", "; FAILS: ", "")));
    }

    /**
     * A pixel of a picture with its true error, in steps.
     *
     * @param renderer of the picture
     */
    public record Outlier(Renderer renderer, int x, int y, double error) {
        /** What happened there, as drawing the pixel alone shows. */
        public String replay() {
            RenderSettings alone = renderer.settings().withWorkers(1, 1).withRegion(new Region(x, y, x + 1, y + 1));
            Drawing drawing = new Drawing(Renderers.with(renderer, alone, renderer.ambientLight()), new Cancellation(),
                Cancellation.Leftovers.DISCARD, DrawingListener.NONE);
            drawing.band(0);
            long further = drawing.errors().furtherRays();
            return String.format(Locale.ROOT, "(%d, %d): %.2f, said %.2f, %d rays", x, y, error,
                drawing.errors().largest(), Math.max(1, further));
        }
    }
}
