package raytracing.render;

import java.util.ArrayList;
import java.util.List;
import raytracing.color.Color;
import raytracing.film.Bands;
import raytracing.film.Film;
import raytracing.shade.RayCounts;

/**
 * A picture in the making. Bands are drawn when they are asked for, by as many threads as the settings say while the
 * calling one waits. How far it is, any thread may ask at any time.
 */
public final class Drawing implements Bands {
    /** Largest number of pixels on a film: with what smooth edges need beside, 240 MB. */
    static final int MOST_PIXELS_IN_A_BAND = 1 << 22;

    private final Renderer renderer;
    private final RenderSettings settings;
    private final Region region;
    private final int bandHeight;
    private final Cancellation cancellation;
    private final Cancellation.Leftovers leftovers;
    private final DrawingListener listener;
    private final Progress progress;
    private RayCounts counts = RayCounts.NONE;
    private long nanoseconds;
    private boolean isPartial;

    /** With bands of a given height. */
    Drawing(Renderer renderer, RenderSettings settings, int bandHeight, Cancellation cancellation,
            Cancellation.Leftovers leftovers, DrawingListener listener) {
        this.renderer = renderer;
        this.settings = settings;
        this.bandHeight = bandHeight;
        this.cancellation = cancellation;
        this.leftovers = leftovers;
        this.listener = listener;
        region = settings.region();
        progress = new Progress(region.pixelCount(), settings.sampling());
    }

    /** All rows if so many are allowed, else whole tiles. */
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
     * @param index of the band, counted from 0 at the top
     * @return the band; if the drawing was cancelled and leftovers are kept, with gaps that show the background
     * @throws CancelledException if the drawing was cancelled and leftovers are discarded, or there are none
     * @throws IllegalStateException if a pixel failed, which is a defect of this program; names the pixel
     */
    @Override
    public Film band(int index) {
        cancellation.drawing();
        try {
            return drawBand(index);
        } finally {
            if (leftovers == Cancellation.Leftovers.DISCARD) {
                cancellation.drawn();        // a picture to be kept is awaited while its bands are written, too
            }
        }
    }

    private Film drawBand(int index) {
        long start = System.nanoTime();
        int top = region.top() + index * bandHeight;
        Region part = new Region(region.left(), top, region.right(), (int) Math.min(region.bottom(), (long) top + bandHeight));
        lookCoarsely(part);
        Exposure exposure = settings.sampling().root() == 1
            ? oneRayEach(part) : new SmoothEdges(renderer, settings).draw(part, this);
        if (!exposure.unfinished().isEmpty()) {
            cancellation.answer();
            leaveGaps(exposure, part);
        } else if (leftovers == Cancellation.Leftovers.KEEP && part.bottom() == region.bottom()) {
            cancellation.answer();           // all is there but the file
        }
        nanoseconds += System.nanoTime() - start;
        return exposure.film();
    }

    private void lookCoarsely(Region part) {
        for (int edge : listener.coarseLooks()) {
            TileQueue squares = new TileQueue(part, edge);
            List<CoarsePass> workers = new ArrayList<>();
            for (int i = 0; i < settings.threads(); i++) {
                workers.add(new CoarsePass(renderer, squares, this));
            }
            run(workers);
        }
    }

    private Exposure oneRayEach(Region part) {
        Film film = new Film(part.width(), part.height());
        TileQueue tiles = new TileQueue(part, settings.tileSize());
        List<OneRayPass> workers = new ArrayList<>();
        for (int i = 0; i < settings.threads(); i++) {
            workers.add(new OneRayPass(renderer, tiles, film, part, this));
        }
        run(workers);
        return new Exposure(film, tiles.unfinished());
    }

    /** Lets workers work until they are done or the drawing is cancelled. */
    void run(List<? extends TileWorker> workers) {
        Crew.run(workers, cancellation);
        for (TileWorker worker : workers) {
            counts = counts.plus(worker.counts());
        }
    }

    private void leaveGaps(Exposure exposure, Region part) {
        if (leftovers == Cancellation.Leftovers.DISCARD || progress.finished() == 0) {
            throw new CancelledException();
        }
        isPartial = true;
        Color background = renderer.background();
        for (Region tile : exposure.unfinished()) {
            for (int y = tile.top(); y < tile.bottom(); y++) {
                for (int x = tile.left(); x < tile.right(); x++) {
                    exposure.film().leaveGap(x - part.left(), y - part.top(), background);
                }
            }
        }
    }

    Cancellation cancellation() {
        return cancellation;
    }

    Progress progress() {
        return progress;
    }

    DrawingListener listener() {
        return listener;
    }

    /**
     * How far the picture is, in rays of the eye. With smooth edges an estimate.
     *
     * @return from 0 to 1
     */
    public double share() {
        return progress.share();
    }

    /**
     * Whether the picture has gaps, because the drawing was cancelled. To be asked when all bands are drawn.
     *
     * @return true if some pixels were not finished
     */
    public boolean isPartial() {
        return isPartial;
    }

    /**
     * How many pixels are what they will be.
     *
     * @return of all bands drawn so far
     */
    public long finishedPixels() {
        return progress.finished();
    }

    /**
     * How many pixels got N x N rays so far, where N is above 1.
     *
     * @return of all bands drawn so far
     */
    public long refinedPixels() {
        return progress.refined();
    }

    /**
     * What the finished tiles of the bands took. To be asked by the thread that asked for them.
     *
     * @return numbers of rays by kind, the same for every number of threads
     */
    public RayCounts counts() {
        return counts;
    }

    /**
     * How long the bands took. To be asked by the thread that asked for them.
     *
     * @return wall time in nanoseconds
     */
    public long nanoseconds() {
        return nanoseconds;
    }
}
