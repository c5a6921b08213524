package raytracing.watch;

import java.awt.Rectangle;
import raytracing.render.Region;

/**
 * Which part of a picture a window shows, and how large. All places are whole pixels of the screen, (0, 0) at the window's
 * upper left corner: so every pixel of the picture is a square of one size at scales from 1 on, and the one under the
 * pointer stays there when the scale doubles or halves.
 *
 * @param picture size of the picture, in its own pixels
 * @param view size of what can be seen, in pixels of the screen
 * @param scale pixels of the screen in the width of one of the picture, above 0; whole powers of 2 but where all is fitted in
 * @param left where the picture begins, at most half the view's width
 * @param top where the picture begins, at most half the view's height
 */
record Viewport(Size picture, Size view, double scale, long left, long top) {
    private static final double LARGEST_SCALE = 64;

    /**
     * Width and height.
     *
     * @param width at least 0; of a picture at least 1
     * @param height likewise
     */
    record Size(int width, int height) {
        /** The largest of this shape, and at most of this size, in a frame. */
        Size within(Size frame) {
            double scale = Math.min(1, ratio(frame));
            return new Size((int) scaled(width, scale), (int) scaled(height, scale));
        }

        private double ratio(Size frame) {
            return Math.min((double) frame.width / width, (double) frame.height / height);
        }
    }

    /** The whole picture in the middle of the view: as large as it is, larger by a power of 2, or as small as it must be. */
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

    /** At the largest scale, a long picture has more pixels of the screen in a row than an int can count. */
    private static long scaled(int length, double scale) {
        return Math.max(1, Math.round(length * scale));
    }

    /** Whether all of the picture is fitted in. */
    boolean isFit() {
        return scale == fittingScale(picture, view);
    }

    /** All of the picture. */
    Viewport fit() {
        return fit(picture, view);
    }

    /** One pixel of the screen for each of the picture, about a place that stays. */
    Viewport oneToOne(int x, int y) {
        return scaledTo(1, x, y);
    }

    /** The next larger power of 2, about a place that stays. */
    Viewport closer(int x, int y) {
        return scaledTo(Math.min(LARGEST_SCALE, 2 * powerUpTo(scale)), x, y);
    }

    /** The next smaller power of 2, about a place that stays, but no smaller than the window and no picture need. */
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

    /** The picture moved by pixels of the screen, as far as it goes. */
    Viewport moved(int right, int down) {
        return placed(view, scale, left + right, top + down);
    }

    /** In a window of another size: all is still fitted in if it was, or what was in the middle still is. */
    Viewport resized(Size newView) {
        return isFit() ? fit(picture, newView) : placed(newView, scale, left + (newView.width / 2 - view.width / 2),
            top + (newView.height / 2 - view.height / 2));
    }

    /** The middle of the view stays over the picture, so that it cannot be lost. */
    private Viewport placed(Size newView, double newScale, long newLeft, long newTop) {
        return new Viewport(picture, newView, newScale, inMiddle(newLeft, newView.width / 2, scaled(picture.width, newScale)),
            inMiddle(newTop, newView.height / 2, scaled(picture.height, newScale)));
    }

    private static long inMiddle(long start, int middle, long length) {
        return Math.max(middle - length + 1, Math.min(middle, start));
    }

    /** The column of the picture at a place in the view; not in the picture if the place is not. */
    int column(int x) {
        return (int) Math.floor((x - left) / scale);
    }

    /** The row of the picture at a place in the view; not in the picture if the place is not. */
    int row(int y) {
        return (int) Math.floor((y - top) / scale);
    }

    /** Whether the picture is at a place in the view. */
    boolean showsPictureAt(int x, int y) {
        return column(x) >= 0 && column(x) < picture.width && row(y) >= 0 && row(y) < picture.height;
    }

    /**
     * The part of the picture that is in view, and a little around it. At scales below 1 it begins where a pixel of the
     * screen does, so that it looks the same as in the whole.
     *
     * @return pixels of the picture, (0, 0) at its corner; at least one, for the middle of the view is over the picture
     */
    Region visible() {
        if (scale < 1 && isFit()) {
            return Region.whole(picture.width, picture.height);
        }
        int block = (int) Math.max(1, 1 / scale);
        return new Region(first(left, block), first(top, block),
            Math.min(picture.width, end(view.width - left, block)), Math.min(picture.height, end(view.height - top, block)));
    }

    /** The block before the one at the view's edge. */
    private int first(long start, int block) {
        return (int) Math.max(0, (long) Math.floor(-start / scale) / block * block - block);
    }

    /** After the block that follows the one at the view's edge. */
    private int end(long length, int block) {
        return (int) Math.min(Integer.MAX_VALUE, ((long) Math.floor(length / scale) / block + 2) * block);
    }

    /**
     * Where a part of the picture is drawn, which may reach out of the view.
     *
     * @param part of the picture that is in view, as {@link #visible} has it
     * @return its place in the view
     */
    Rectangle placeOf(Region part) {
        int x = (int) (left + Math.round(part.left() * scale));
        int y = (int) (top + Math.round(part.top() * scale));
        return new Rectangle(x, y, (int) scaled(part.width(), scale), (int) scaled(part.height(), scale));
    }

    /**
     * Where pixels of the picture are seen.
     *
     * @param part of the picture, (0, 0) at its corner
     * @return all places in the view that may look different if these pixels are; empty if they are not in view
     */
    Rectangle onView(Region part) {
        int beside = scale < 1 ? 1 : 0;          // small pictures are blurred with their neighbours, on the screen too
        int x = within(view.width, left + Math.floor((part.left() - beside) * scale) - beside);
        int y = within(view.height, top + Math.floor((part.top() - beside) * scale) - beside);
        return new Rectangle(x, y, within(view.width, left + Math.ceil((part.right() + beside) * scale) + beside) - x,
            within(view.height, top + Math.ceil((part.bottom() + beside) * scale) + beside) - y);
    }

    private static int within(int length, double place) {
        return (int) Math.max(0, Math.min(length, place));
    }
}
