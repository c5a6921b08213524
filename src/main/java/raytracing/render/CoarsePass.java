package raytracing.render;

import raytracing.color.Color;

/** Shows one pixel in the middle of each square of pixels, whose tiles are the squares. */
final class CoarsePass extends TileWorker {
    private final Renderer renderer;
    private final DrawingListener listener;
    private Color light = Color.BLACK;

    CoarsePass(Renderer renderer, TileQueue squares, Drawing drawing) {
        super(renderer, squares, drawing.cancellation());
        this.renderer = renderer;
        listener = drawing.listener();
    }

    @Override
    void drawAll(Region square) {
        drawNamed(square.left() + square.width() / 2, square.top() + square.height() / 2);
    }

    @Override
    void draw(int x, int y) {
        light = renderer.oneRay(shader, x, y).total();
    }

    @Override
    void finished(Region square) {
        listener.showSquare(square, light);
    }
}
