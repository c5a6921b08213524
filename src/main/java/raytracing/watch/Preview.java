package raytracing.watch;

import java.util.Optional;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.render.Cancellation;
import raytracing.render.Drawing;
import raytracing.render.DrawingListener;
import raytracing.render.Region;

/** A window. */
final class Preview implements DrawingListener {
    static Optional<Preview> open(String output, Region region, Cancellation cancellation) {
        return Optional.empty();
    }

    void follow(Drawing drawing, long start) {
    }

    void end(String summary) {
    }

    void awaitClosed() {
    }

    @Override
    public int[] coarseLooks() {
        return new int[] {16, 4};
    }

    @Override
    public void showSquare(Region square, Color light) {
    }

    @Override
    public void showTile(Region tile, Film film, Region filmed) {
    }
}
