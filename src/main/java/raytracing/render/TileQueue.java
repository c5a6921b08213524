package raytracing.render;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Deals the tiles of a part of a picture, each to one thread, and keeps a list of those that are finished. Thread-safe.
 *
 * <p>Neighbours are dealt far apart: after each tile comes the one that lies the golden section of all of them further
 * on. So the tiles dealt are spread evenly over the part at any time (Weyl's sequence), and the share that is done says
 * how long the rest will take.
 */
final class TileQueue {
    private static final double GOLDEN_SECTION = 0.6180339887498949;

    private final Region part;
    private final int tileSize;
    private final int firstLeft;
    private final int firstTop;
    private final int columns;
    private final int count;
    private final int stride;
    private final AtomicLong dealt = new AtomicLong();
    private final BitSet finished;

    /** With the first tile in the part's upper left corner. */
    TileQueue(Region part, int tileSize) {
        this(part, tileSize, part.left(), part.top());
    }

    /** With tiles of a grid, one of whose corners is given; those at the part's border are cut off by it. */
    TileQueue(Region part, int tileSize, int gridX, int gridY) {
        this.part = part;
        this.tileSize = tileSize;
        firstLeft = part.left() - Math.floorMod(part.left() - gridX, tileSize);
        firstTop = part.top() - Math.floorMod(part.top() - gridY, tileSize);
        columns = tilesIn(part.right() - firstLeft);
        count = Math.multiplyExact(columns, tilesIn(part.bottom() - firstTop));
        stride = strideFrom(Math.max(1, (int) Math.round(GOLDEN_SECTION * count)));
        finished = new BitSet(count);
    }

    private int tilesIn(int length) {
        return (int) (((long) length + tileSize - 1) / tileSize);
    }

    /** The first number from {@code least} on without a divisor in common with the count: its multiples reach every tile. */
    private int strideFrom(int least) {
        return greatestCommonDivisor(least, count) == 1 ? least : strideFrom(least + 1);
    }

    private static int greatestCommonDivisor(int a, int b) {
        return b == 0 ? a : greatestCommonDivisor(b, a % b);
    }

    /** The next tile, or none if all are dealt. */
    Optional<Region> next() {
        long i = dealt.getAndIncrement();
        return i < count ? Optional.of(tile((int) (i * stride % count))) : Optional.empty();
    }

    private Region tile(int number) {
        int left = firstLeft + number % columns * tileSize;
        int top = firstTop + number / columns * tileSize;
        return new Region(Math.max(part.left(), left), Math.max(part.top(), top),
            (int) Math.min(part.right(), (long) left + tileSize), (int) Math.min(part.bottom(), (long) top + tileSize));
    }

    /** Deals no more tiles. */
    void close() {
        dealt.set(count);
    }

    /** Marks a tile whose pixels are all final. */
    synchronized void finish(Region tile) {
        finished.set((tile.top() - firstTop) / tileSize * columns + (tile.left() - firstLeft) / tileSize);
    }

    /** The tiles that are not finished yet; the caller sees all pixels of the others (happens-before). */
    synchronized List<Region> unfinished() {
        List<Region> tiles = new ArrayList<>();
        for (int i = finished.nextClearBit(0); i < count; i = finished.nextClearBit(i + 1)) {
            tiles.add(tile(i));
        }
        return tiles;
    }
}
