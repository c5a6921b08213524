package raytracing.render;

import java.util.List;
import java.util.Optional;
import raytracing.color.Color;
import raytracing.film.Bands;
import raytracing.film.Film;
import raytracing.shade.RayCounts;

/**
 * A picture that is drawn band by band. {@link #band} draws a band on as many threads as the settings say, while the calling
 * thread waits. Other threads may read how far the drawing is.
 */
public final class Drawing implements Bands {
    /** Most pixels on the film of a band: 240 MB with what smooth edges need in addition. */
    static final int MOST_PIXELS_IN_A_BAND = 1 << 22;

    private final Renderer renderer;
    private final RenderSettings settings;
    private final Region region;
    private final int bandHeight;
    private final Cancellation cancellation;
    private final Cancellation.Leftovers leftovers;
    private final DrawingListener listener;
    private final Progress progress;
    private final ErrorTally errors = new ErrorTally();
    private RayCounts counts = RayCounts.NONE;
    private long nanoseconds;
    private boolean isPartial;

    /** A drawing of the region of the renderer's settings, not begun; the listener gets the pixels as they are drawn. */
    public Drawing(Renderer renderer, Cancellation cancellation, Cancellation.Leftovers leftovers, DrawingListener listener) {
        this(renderer, bandHeight(renderer.settings().region(), renderer.settings().tileSize()), cancellation, leftovers,
            listener);
    }

    /** With bands of a given height. */
    Drawing(Renderer renderer, int bandHeight, Cancellation cancellation, Cancellation.Leftovers leftovers,
            DrawingListener listener) {
        this.renderer = renderer;
        this.bandHeight = bandHeight;
        this.cancellation = cancellation;
        this.leftovers = leftovers;
        this.listener = listener;
        settings = renderer.settings();
        region = settings.region();
        progress = new Progress(region.pixelCount(), settings.sampling());
    }

    /** All rows if a band may have so many pixels, otherwise as many whole tiles as it may have. */
    static int bandHeight(Region region, int tileSize) {
        if (region.pixelCount() <= MOST_PIXELS_IN_A_BAND) {
            return region.height();
        }
        long rows = MOST_PIXELS_IN_A_BAND / region.width();
        return (int) Math.max(1, rows > tileSize ? rows - rows % tileSize : rows);
    }

    @Override
    public int width() {
        return region.width();
    }

    @Override
    public int height() {
        return region.height();
    }

    @Override
    public int bandHeight() {
        return bandHeight;
    }

    /**
     * Draws a band.
     *
     * @param index counted from 0 at the top
     * @return if the drawing was cancelled and leftovers are kept, with gaps that show the background
     * @throws CancelledException if the drawing was cancelled and leftovers are discarded, or no pixel is finished
     * @throws IllegalStateException if a pixel failed, which is a defect of this program; names the pixel
     */
    @Override
    public Film band(int index) {
        long start = System.nanoTime();
        int top = region.top() + index * bandHeight;
        Region part = new Region(region.left(), top, region.right(), (int) Math.min(region.bottom(), (long) top + bandHeight));
        cancellation.beginDrawing();
        try {
            for (int edge : listener.coarseLooks()) {
                pass(new TileQueue(part, edge), CoarseLook.of(part, edge, listener));
            }
            return draw(part);
        } finally {
            nanoseconds += System.nanoTime() - start;
            if (leftovers == Cancellation.Leftovers.DISCARD) {
                cancellation.endDrawing();        // a picture to be kept is waited for while its bands are written, too
            }
        }
    }

    private Film draw(Region part) {
        if (settings.sampling() instanceof PixelGrid grid) {
            return draw(grid, part);
        }
        return drawToLimit(part);
    }

    private Film draw(PixelGrid grid, Region part) {
        if (grid.root() == 1) {
            OneRayEach painter = OneRayEach.of(part, progress, listener);
            return finish(part, painter.film(), new TileQueue(part, settings.tileSize()), painter);
        }
        if (grid.where() == PixelGrid.Where.EVERYWHERE) {
            return smooth(grid, part, new Film(part.width(), part.height()), Optional.empty());
        }
        Region filmed = part.withNeighbours(settings.width(), settings.height());
        OneRayEach first = OneRayEach.findingEdges(part, filmed, progress, listener);
        pass(new TileQueue(filmed, settings.tileSize()), first);
        return smooth(grid, part, first.filmOfPart(), Optional.of(first));
    }

    private Film smooth(PixelGrid grid, Region part, Film film, Optional<OneRayEach> first) {
        return finish(part, film, new TileQueue(part, settings.tileSize()),
            new SmoothEdges(grid, part, film, first, progress, listener));
    }

    private Film drawToLimit(Region part) {
        FirstRays first = new FirstRays(part, progress, listener);
        pass(new TileQueue(first.filmed(), settings.tileSize()), first);
        TileQueue blocks = new TileQueue(part, settings.tileSize(), 0, 0);       // outlines are found in blocks of the picture
        return finish(part, first.film(), blocks, new ErrorRefinement(part, first, errors, progress, listener));
    }

    /** The last pass over a part; returns the film, if there is to be one, with gaps in place of the unfinished tiles. */
    private Film finish(Region part, Film film, TileQueue tiles, PixelPainter painter) {
        List<Region> unfinished = pass(tiles, painter);
        if (!unfinished.isEmpty()) {
            cancellation.confirmEnd();
            if (leftovers == Cancellation.Leftovers.DISCARD || progress.finished() == 0) {
                throw new CancelledException();
            }
            isPartial = true;
            for (Region tile : unfinished) {
                leaveGap(film, part, tile);
            }
        } else if (leftovers == Cancellation.Leftovers.KEEP && part.bottom() == region.bottom()) {
            cancellation.confirmEnd();           // only the file is still to be written
        }
        return film;
    }

    /** One pass over tiles; returns those that are not finished because the drawing was cancelled. */
    private List<Region> pass(TileQueue tiles, PixelPainter painter) {
        counts = counts.plus(new TilePass(tiles, painter, cancellation).run(renderer));
        return tiles.unfinished();
    }

    private void leaveGap(Film film, Region part, Region tile) {
        Color background = renderer.scene().settings().background();
        for (int y = tile.top(); y < tile.bottom(); y++) {
            for (int x = tile.left(); x < tile.right(); x++) {
                film.leaveGap(x - part.left(), y - part.top(), background);
            }
        }
    }

    /** How far the drawing is; for any thread. */
    public Progress progress() {
        return progress;
    }

    /** Whether the picture has gaps, because the drawing was cancelled; known when all bands are drawn. */
    public boolean isPartial() {
        return isPartial;
    }

    /** What the finished tiles of the bands took, the same for every number of threads; for the thread that draws them. */
    public RayCounts counts() {
        return counts;
    }

    /** What pixels got under an error limit, and their errors, of the finished tiles; for the thread that draws them. */
    public ErrorTally errors() {
        return errors;
    }

    /** How long the bands took to draw, wall time; for the thread that draws them. */
    public long nanoseconds() {
        return nanoseconds;
    }
}
