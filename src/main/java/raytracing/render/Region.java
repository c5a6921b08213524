package raytracing.render;

/**
 * A rectangle of pixels of a picture.
 *
 * @param left first column, at least 0 (-1 in the margin around a picture)
 * @param top first row, at least 0 (-1 in the margin)
 * @param right column after the last, above {@code left}
 * @param bottom row after the last, above {@code top}
 */
public record Region(int left, int top, int right, int bottom) {
    /** All of a picture. */
    public static Region whole(int width, int height) {
        return new Region(0, 0, width, height);
    }

    public int width() {
        return right - left;
    }

    public int height() {
        return bottom - top;
    }

    public long pixelCount() {
        return (long) width() * height();
    }

    boolean contains(int x, int y) {
        return x >= left && x < right && y >= top && y < bottom;
    }

    /** The pixels that are also in another region, which this one overlaps or touches. */
    Region intersection(Region other) {
        return new Region(Math.max(left, other.left), Math.max(top, other.top),
            Math.min(right, other.right), Math.min(bottom, other.bottom));
    }

    /** The region with the pixels around it, whether a picture has them or not. */
    Region withMargin() {
        return new Region(left - 1, top - 1, right + 1, bottom + 1);
    }

    /** The region with the pixels around it that a picture has. */
    Region withNeighbours(int pictureWidth, int pictureHeight) {
        return withMargin().intersection(whole(pictureWidth, pictureHeight));
    }
}
