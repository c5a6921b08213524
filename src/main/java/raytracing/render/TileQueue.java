package raytracing.render;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;

/** Deals out the tiles of a picture, row by row, to whichever thread asks next. */
final class TileQueue {
    private final int width;
    private final int height;
    private final int tileSize;
    private final long columns;
    private final long count;
    private final AtomicLong dealt = new AtomicLong();

    TileQueue(int width, int height, int tileSize) {
        this.width = width;
        this.height = height;
        this.tileSize = tileSize;
        columns = rounded(width);
        count = columns * rounded(height);
    }

    private long rounded(int length) {
        return ((long) length + tileSize - 1) / tileSize;
    }

    /** A tile that nobody else gets, or none if all are dealt. */
    Optional<Tile> next() {
        long i = dealt.getAndIncrement();
        if (i >= count) {
            return Optional.empty();
        }
        long left = i % columns * tileSize;
        long top = i / columns * tileSize;
        return Optional.of(new Tile((int) left, (int) top,
            (int) Math.min(width, left + tileSize), (int) Math.min(height, top + tileSize)));
    }

    /** No more tiles for anybody. */
    void close() {
        dealt.set(count);
    }
}
