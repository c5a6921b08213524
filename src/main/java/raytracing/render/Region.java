package raytracing.render;

/**
 * A rectangle of pixels of a picture.
 *
 * @param left first column, at least 0
 * @param top first row, at least 0
 * @param right column after the last, above {@code left}
 * @param bottom row after the last, above {@code top}
 */
public record Region(int left, int top, int right, int bottom) {
    /**
     * All of a picture.
     *
     * @param width of the picture in pixels
     * @param height of the picture in pixels
     * @return the whole
     */
    public static Region whole(int width, int height) {
        return new Region(0, 0, width, height);
    }

    /**
     * Its width.
     *
     * @return number of columns
     */
    public int width() {
        return right - left;
    }

    /**
     * Its height.
     *
     * @return number of rows
     */
    public int height() {
        return bottom - top;
    }

    /**
     * Its area.
     *
     * @return number of pixels
     */
    public long pixelCount() {
        return (long) width() * height();
    }

    /** What of it is in another one that it overlaps or touches. */
    Region within(Region other) {
        return new Region(Math.max(left, other.left), Math.max(top, other.top),
            Math.min(right, other.right), Math.min(bottom, other.bottom));
    }

    /** With the pixels around it, as far as they are in a picture. */
    Region withNeighbours(int pictureWidth, int pictureHeight) {
        return new Region(Math.max(left - 1, 0), Math.max(top - 1, 0),
            Math.min(right + 1, pictureWidth), Math.min(bottom + 1, pictureHeight));
    }
}
