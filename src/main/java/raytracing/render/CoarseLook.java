package raytracing.render;

import raytracing.color.MutableColor;
import raytracing.film.Film;

/**
 * Shows one pixel in the middle of each square of pixels; the squares are the tiles.
 *
 * @param edge of the squares in pixels
 * @param film with one pixel for each square
 */
record CoarseLook(Region part, int edge, Film film, DrawingListener listener) implements PixelPainter {
    static CoarseLook of(Region part, int edge, DrawingListener listener) {
        return new CoarseLook(part, edge, new Film((part.width() - 1) / edge + 1, (part.height() - 1) / edge + 1), listener);
    }

    @Override
    public Region paintedPixels(Region square) {
        int x = square.left() + square.width() / 2;
        int y = square.top() + square.height() / 2;
        return new Region(x, y, x + 1, y + 1);
    }

    @Override
    public void paint(int x, int y, PixelLight light) {
        MutableColor sum = light.ofOneRay(x, y);
        film.set((x - part.left()) / edge, (y - part.top()) / edge, sum.red(), sum.green(), sum.blue());
    }

    @Override
    public void finished(Region square, PixelLight light) {
        listener.showSquare(square, film.get((square.left() - part.left()) / edge, (square.top() - part.top()) / edge));
    }
}
