package raytracing.watch;

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
 * What is known of a picture so far: several threads write, each its own pixels, while another shows them.
 *
 * <p>The pixels are written without a lock. Whoever writes some tells of them in {@link #tell} afterwards, and whoever shows them
 * asks {@link #takeChanges} first; both hold the same lock, so all that was told is seen. A pixel that is just being
 * written may be seen as it was or as it will be, for an int is never seen in part; it is told of soon, and shown again.
 */
final class ShownPicture implements DrawingListener {
    /** States of a pixel, in the byte that is not shown. */
    private static final int STATE = 0xff000000;
    private static final int FINISHED = 0x01000000;

    private static final int RED = 0xff0000;
    private static final int GREEN = 0xff00;
    private static final int BLUE = 0xff;

    /** What is not drawn yet: a quiet chequer, of 64 to 128 squares in the longer side of a large picture. */
    private static final int[] NOT_YET = {0x2e3032, 0x383a3d};
    private static final int LEAST_SQUARE = 8;
    private static final int MOST_SQUARES = 128;

    private static final int[] RELEASED = {};

    /** The coarsest look is there at once, the next one shows what it is going to be. */
    private static final int[] LOOKS = {16, 4};
    private static final int[] NO_LOOKS = {};

    private final Region region;
    private final int width;
    private volatile int[] pixels;

    /** What changed since somebody asked, from the picture's corner; nothing if right is 0. */
    private int left;
    private int top;
    private int right;
    private int bottom;

    private ShownPicture(Region region, int[] pixels) {
        this.region = region;
        this.pixels = pixels;
        width = region.width();
    }

    /** Of a part of a picture, of at most as many pixels as an array has elements: nothing is drawn yet. */
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

    /** Another one that looks the same, to be drawn over. */
    ShownPicture copy() {
        return new ShownPicture(region, pixels.clone());
    }

    /** What it shows of the whole picture. */
    Region region() {
        return region;
    }

    @Override
    public int[] coarseLooks() {
        return isReleased() ? NO_LOOKS : LOOKS;
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
            tell(square);
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
            tell(tile);
        }
    }

    private synchronized void tell(Region changed) {
        if (changed.pixelCount() == 0) {
            return;                              // a tile of neighbours that the picture does not have
        }
        boolean isFirst = right == 0;
        left = isFirst ? changed.left() - region.left() : Math.min(left, changed.left() - region.left());
        top = isFirst ? changed.top() - region.top() : Math.min(top, changed.top() - region.top());
        right = Math.max(right, changed.right() - region.left());
        bottom = Math.max(bottom, changed.bottom() - region.top());
    }

    /** A rectangle around all that changed since this was asked last, (0, 0) at the upper left corner of what is shown. */
    synchronized Optional<Region> takeChanges() {
        Optional<Region> changes = right == 0 ? Optional.empty() : Optional.of(new Region(left, top, right, bottom));
        right = 0;
        bottom = 0;
        return changes;
    }

    /** Nobody looks any more: nothing is converted or kept from now on. */
    void release() {
        pixels = RELEASED;
    }

    /** Whether nobody looks any more. */
    boolean isReleased() {
        return pixels.length == 0;
    }

    /** All of it as it is, and as it will be: nothing is copied; none if nobody looks. */
    Optional<BufferedImage> image() {
        int[] shown = pixels;
        return shown.length == 0 ? Optional.empty() : Optional.of(new BufferedImage(
            new DirectColorModel(24, RED, GREEN, BLUE), Raster.createPackedRaster(new DataBufferInt(shown, shown.length),
            width, region.height(), width, new int[] {RED, GREEN, BLUE}, null), false, null));
    }

    /**
     * A pixel in words.
     *
     * @param column from the left of what is shown, in its range
     * @param row from the top
     * @return its place in the whole picture, and red, green and blue from 0 to 255 if they are known
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
