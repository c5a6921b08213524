package raytracing.preview;

import java.awt.Rectangle;
import raytracing.render.Region;

/**
 * Which part of a picture a window shows, and how large. All places are whole pixels of the screen, (0, 0) at the view's upper
 * left corner. So at scales from 1 on, all pixels of the picture are squares of one size, and the one under the pointer stays
 * there when the scale doubles or halves.
 *
 * @param picture size of the picture, in its own pixels
 * @param view size of the visible area, in pixels of the screen
 * @param scale width of a pixel of the picture in pixels of the screen, above 0; a whole power of 2 unless all is fitted in
 * @param left column of the picture's left edge, at most half the view's width
 * @param top row of the picture's upper edge, at most half the view's height
 */
record Viewport(Size picture, Size view, double scale, long left, long top) {
    private static final double LARGEST_SCALE = 64;

    /** Width and height, at least 0; those of a picture at least 1. */
    record Size(int width, int height) {
        /** The largest size of this shape that fits in a frame and is at most this size. */
        Size within(Size frame) {
            double scale = Math.min(1, ratio(frame));
            return new Size((int) scaled(width, scale), (int) scaled(height, scale));
        }

        private double ratio(Size frame) {
            return Math.min((double) frame.width / width, (double) frame.height / height);
        }
    }

    /** The whole picture in the middle of the view: one to one, larger by a power of 2, or as much smaller as needed. */
    static Viewport fit(Size picture, Size view) {
        double scale = fittingScale(picture, view);
        return new Viewport(picture, view, scale, (view.width - scaled(picture.width, scale)) / 2,
            (view.height - scaled(picture.height, scale)) / 2);
    }

    private static double fittingScale(Size picture, Size view) {
        double ratio = picture.ratio(new Size(Math.max(1, view.width), Math.max(1, view.height)));
        return ratio < 1 ? ratio : Math.min(LARGEST_SCALE, powerUpTo(ratio));
    }

    private static double powerUpTo(double scale) {
        return Math.scalb(1.0, Math.getExponent(scale));
    }

    /** A long, as at the largest scale a long picture is wider than the range of int. */
    private static long scaled(int length, double scale) {
        return Math.max(1, Math.round(length * scale));
    }

    /** Whether the whole picture is fitted in. */
    boolean isFit() {
        return scale == fittingScale(picture, view);
    }

    Viewport fit() {
        return fit(picture, view);
    }

    /** One pixel of the screen for each of the picture, around a place that stays. */
    Viewport oneToOne(int x, int y) {
        return scaledTo(1, x, y);
    }

    /** The next larger power of 2, around a place that stays. */
    Viewport closer(int x, int y) {
        return scaledTo(Math.min(LARGEST_SCALE, 2 * powerUpTo(scale)), x, y);
    }

    /** The next smaller power of 2, around a place that stays, but not below the lesser of 1 and the fitting scale. */
    Viewport farther(int x, int y) {
        double power = powerUpTo(scale);
        return scaledTo(Math.max(power < scale ? power : power / 2, Math.min(1, fittingScale(picture, view))), x, y);
    }

    private Viewport scaledTo(double newScale, int x, int y) {
        if (newScale == scale) {
            return this;
        }
        Viewport about = placed(view, newScale, x - (long) Math.floor((x - left) * newScale / scale),
            y - (long) Math.floor((y - top) * newScale / scale));
        return about.isFit() ? fit() : about;
    }

    /** The picture moved by pixels of the screen, while the middle of the view stays over it. */
    Viewport moved(int right, int down) {
        return placed(view, scale, left + right, top + down);
    }

    /** In a view of another size: the whole picture still fits if it did, else what was in the middle stays there. */
    Viewport resized(Size newView) {
        return isFit() ? fit(picture, newView) : placed(newView, scale, left + (newView.width / 2 - view.width / 2),
            top + (newView.height / 2 - view.height / 2));
    }

    /** Keeps the middle of the view over the picture, so that it cannot be lost. */
    private Viewport placed(Size newView, double newScale, long newLeft, long newTop) {
        return new Viewport(picture, newView, newScale, inMiddle(newLeft, newView.width / 2, scaled(picture.width, newScale)),
            inMiddle(newTop, newView.height / 2, scaled(picture.height, newScale)));
    }

    private static long inMiddle(long start, int middle, long length) {
        return Math.max(middle - length + 1, Math.min(middle, start));
    }

    /** The column of the picture at a place in the view, beyond its edges if the place is. */
    int column(int x) {
        return (int) Math.floor((x - left) / scale);
    }

    /** The row of the picture at a place in the view, beyond its edges if the place is. */
    int row(int y) {
        return (int) Math.floor((y - top) / scale);
    }

    /** Whether the picture is at a place in the view. */
    boolean showsPictureAt(int x, int y) {
        return column(x) >= 0 && column(x) < picture.width && row(y) >= 0 && row(y) < picture.height;
    }

    /**
     * The part of the picture that is in view, and a little around it, in pixels of the picture; at least one pixel, since the
     * middle of the view is over the picture. At scales below 1 it begins where a pixel of the screen does, so that it looks
     * the same as within the whole.
     */
    Region visible() {
        if (scale < 1 && isFit()) {
            return Region.whole(picture.width, picture.height);
        }
        int block = (int) Math.max(1, 1 / scale);
        return new Region(first(left, block), first(top, block),
            Math.min(picture.width, end(view.width - left, block)), Math.min(picture.height, end(view.height - top, block)));
    }

    /** The start of the block before the one at the view's edge. */
    private int first(long start, int block) {
        return (int) Math.max(0, (long) Math.floor(-start / scale) / block * block - block);
    }

    /** The end of the block after the one at the view's edge. */
    private int end(long length, int block) {
        return (int) Math.min(Integer.MAX_VALUE, ((long) Math.floor(length / scale) / block + 2) * block);
    }

    /** Where the {@link #visible} part of the picture is drawn; may extend beyond the view. */
    Rectangle placeOf(Region part) {
        int x = (int) (left + Math.round(part.left() * scale));
        int y = (int) (top + Math.round(part.top() * scale));
        return new Rectangle(x, y, (int) scaled(part.width(), scale), (int) scaled(part.height(), scale));
    }

    /** All places in the view that may look different if a part of the picture does; empty if it is not in view. */
    Rectangle onView(Region part) {
        int margin = scale < 1 ? 1 : 0;          // at these scales a pixel is blended with its neighbours, on the screen too
        int x = within(view.width, left + Math.floor((part.left() - margin) * scale) - margin);
        int y = within(view.height, top + Math.floor((part.top() - margin) * scale) - margin);
        return new Rectangle(x, y, within(view.width, left + Math.ceil((part.right() + margin) * scale) + margin) - x,
            within(view.height, top + Math.ceil((part.bottom() + margin) * scale) + margin) - y);
    }

    private static int within(int length, double place) {
        return (int) Math.max(0, Math.min(length, place));
    }
}
