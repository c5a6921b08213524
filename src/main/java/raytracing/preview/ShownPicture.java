package raytracing.preview;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.awt.image.DirectColorModel;
import java.awt.image.Raster;
import java.util.Arrays;
import java.util.Optional;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.render.DrawingListener;
import raytracing.render.Region;

/**
 * The pixels of a picture that are known so far. Thread-safe: several threads write, each its own pixels, while another thread
 * shows them.
 *
 * <p>The pixels are written without a lock. A thread that has written some calls {@link #noteChange} afterwards, and the
 * thread that shows them calls {@link #takeChanges} first. Both hold the same lock, so all noted changes are visible. A pixel
 * that is just being written has its old or its new value, since an int is written at once.
 */
final class ShownPicture implements DrawingListener {
    /** The state of a pixel is in the byte that is not shown. */
    private static final int STATE = 0xff000000;
    private static final int FINISHED = 0x01000000;

    private static final int RED = 0xff0000;
    private static final int GREEN = 0xff00;
    private static final int BLUE = 0xff;

    /** Colours of the chequer where nothing is drawn yet, of 64 to 128 squares along the longer side of a large picture. */
    private static final int[] NOT_YET = {0x2e3032, 0x383a3d};
    private static final int LEAST_SQUARE = 8;
    private static final int MOST_SQUARES = 128;

    /** Edges of the squares of coarse looks: the first is drawn at once, the second shows what the picture will be. */
    private static final int[] LOOKS = {16, 4};
    private static final int[] NOTHING = {};

    private final Region region;
    private final int width;
    private volatile int[] pixels;

    /** The rectangle around the changes that were not taken yet, in coordinates of the whole picture. */
    private Optional<Region> changes = Optional.empty();

    private ShownPicture(Region region, int[] pixels) {
        this.region = region;
        this.pixels = pixels;
        width = region.width();
    }

    /** A region of a picture, with at most as many pixels as an array may have elements; nothing is drawn yet. */
    ShownPicture(Region region) {
        this(region, blank(region));
    }

    private static int[] blank(Region region) {
        int width = region.width();
        int[] blank = new int[Math.multiplyExact(width, region.height())];
        int square = Math.max(LEAST_SQUARE, Integer.highestOneBit(Math.max(width, region.height()) / MOST_SQUARES) * 2);
        for (int y = 0; y < region.height(); y++) {
            for (int x = 0; x < width; x++) {
                blank[y * width + x] = NOT_YET[(x / square + y / square) & 1];
            }
        }
        return blank;
    }

    /** A copy to be drawn over. */
    ShownPicture copy() {
        return new ShownPicture(region, pixels.clone());
    }

    Region region() {
        return region;
    }

    @Override
    public int[] coarseLooks() {
        return pixels.length == 0 ? NOTHING : LOOKS;
    }

    @Override
    public void showSquare(Region square, Color light) {
        int[] target = pixels;
        if (target.length > 0) {
            int encoded = Film.encoded(light);
            for (int y = square.top(); y < square.bottom(); y++) {
                int start = (y - region.top()) * width + square.left() - region.left();
                Arrays.fill(target, start, start + square.width(), encoded);
            }
            noteChange(square);
        }
    }

    @Override
    public void showTile(Region tile, Film film, Region filmed) {
        int[] target = pixels;
        if (target.length > 0) {
            for (int y = tile.top(); y < tile.bottom(); y++) {
                int start = (y - region.top()) * width - region.left();
                for (int x = tile.left(); x < tile.right(); x++) {
                    target[start + x] = FINISHED | film.encoded(x - filmed.left(), y - filmed.top());
                }
            }
            noteChange(tile);
        }
    }

    private synchronized void noteChange(Region changed) {
        if (changed.pixelCount() > 0) {          // a tile of neighbours outside the picture has none
            Region others = changes.orElse(changed);
            changes = Optional.of(new Region(Math.min(others.left(), changed.left()), Math.min(others.top(), changed.top()),
                Math.max(others.right(), changed.right()), Math.max(others.bottom(), changed.bottom())));
        }
    }

    /** The rectangle around all changes since the last call, (0, 0) at the upper left corner of the region; empty if none. */
    synchronized Optional<Region> takeChanges() {
        Optional<Region> taken = changes.map(all -> new Region(all.left() - region.left(), all.top() - region.top(),
            all.right() - region.left(), all.bottom() - region.top()));
        changes = Optional.empty();
        return taken;
    }

    /** The window is closed: from now on no pixels are converted or kept. */
    void release() {
        pixels = NOTHING;
    }

    /** An image that shares the pixels, also those that are drawn later; empty once this is released. */
    Optional<BufferedImage> image() {
        int[] shown = pixels;
        return shown.length == 0 ? Optional.empty() : Optional.of(new BufferedImage(
            new DirectColorModel(24, RED, GREEN, BLUE), Raster.createPackedRaster(new DataBufferInt(shown, shown.length),
            width, region.height(), width, new int[] {RED, GREEN, BLUE}, null), false, null));
    }

    /**
     * The place of a pixel in the whole picture, and red, green and blue from 0 to 255 if they are known.
     *
     * @param column from the left of the region
     * @param row from the top of the region
     */
    String describe(int column, int row) {
        int[] shown = pixels;
        int pixel = shown.length == 0 ? 0 : shown[row * width + column];
        String place = region.left() + column + ", " + (region.top() + row);
        return (pixel & STATE) == FINISHED
            ? place + ":  " + (pixel >> 16 & BLUE) + " " + (pixel >> 8 & BLUE) + " " + (pixel & BLUE)
            : place + ":  not drawn yet";
    }
}
