package raytracing.render;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.DoubleAdder;
import java.util.concurrent.atomic.LongAdder;
import java.util.stream.IntStream;
import raytracing.film.Film;

/** True errors of pictures with N x N rays in each pixel or at edges: only the pixels that a truth knows are drawn. */
public final class GridErrors {
    private final Renderer renderer;
    private final TrueLight truth;
    private final OneRayEach first;

    /** Draws a picture with one ray through each pixel, to know where the edges are. */
    public GridErrors(Renderer given, TrueLight truth) {
        renderer = Renderers.withSampling(given, PixelGrid.ONE_RAY);
        this.truth = truth;
        Region whole = Region.whole(truth.width(), truth.height());
        first = OneRayEach.findingEdges(whole, whole, new Progress(whole.pixelCount(), PixelGrid.ONE_RAY),
            DrawingListener.NONE);
        new TilePass(new TileQueue(whole, renderer.settings().tileSize()), first, new Cancellation()).run(renderer);
    }

    /** Root of the mean square of the errors of the pixels that vary, in steps. */
    public double rootMeanSquare(PixelGrid grid) {
        AtomicInteger nextRow = new AtomicInteger();
        DoubleAdder squares = new DoubleAdder();
        LongAdder pixels = new LongAdder();
        IntStream.range(0, Runtime.getRuntime().availableProcessors()).parallel().forEach(worker -> {
            PixelLight light = new PixelLight(renderer);
            for (int y = nextRow.getAndIncrement(); y < truth.height(); y = nextRow.getAndIncrement()) {
                for (int x = 0; x < truth.width(); x++) {
                    if (truth.isVaried(x, y)) {
                        squares.add(squaredError(grid, x, y, light));
                        pixels.increment();
                    }
                }
            }
        });
        return rootMeanSquare(squares.sum(), pixels.sum());
    }

    /** The same of a picture that is there. */
    public static double rootMeanSquare(Film film, TrueLight truth) {
        double squares = 0;
        long pixels = 0;
        for (int y = 0; y < truth.height(); y++) {
            for (int x = 0; x < truth.width(); x++) {
                if (truth.isVaried(x, y)) {
                    squares += truth.squaredError(x, y, film.get(x, y));
                    pixels++;
                }
            }
        }
        return rootMeanSquare(squares, pixels);
    }

    private static double rootMeanSquare(double squares, long pixels) {
        return pixels == 0 ? 0 : Math.sqrt(Math.max(0, squares / pixels));
    }

    private double squaredError(PixelGrid grid, int x, int y, PixelLight light) {
        if (grid.root() == 1 || grid.where() == PixelGrid.Where.EDGES && !first.isEdge(x, y)) {
            return truth.squaredError(x, y, first.film().get(x, y));
        }
        Film one = new Film(1, 1);
        light.exposeRefined(grid, x, y, one, 0, 0);
        return truth.squaredError(x, y, one.get(0, 0));
    }
}
