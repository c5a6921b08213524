package raytracing.render;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import raytracing.parallel.HelperThreads;
import raytracing.shade.RayCounts;

/** One pass over the tiles of a part of a picture: threads draw them while the calling thread waits. */
record TilePass(TileQueue tiles, PixelPainter painter, Cancellation cancellation) {
    /**
     * How long the first drawing of a virtual machine leaves one processor to its compilers. Code that is compiled sooner draws
     * more than another thread that runs it uncompiled (tuned by measurement: DECISIONS).
     */
    private static final long COLD_NANOSECONDS = 150_000_000;

    private static final long FIRST_PASS = System.nanoTime();

    /** How often the waiting thread checks whether the drawing was cancelled. */
    private static final long POLL_NANOSECONDS = 20_000_000;

    /** How long it waits after that for the pixels that are being drawn, each of which may take seconds. */
    private static final long PATIENCE_NANOSECONDS = 50_000_000;

    /**
     * Draws with as many threads as the renderer's settings say, at first with fewer than there are processors. Returns the
     * counts of the finished tiles when all are drawn, or soon after a cancellation; what a slow thread still draws then is
     * lost. Throws what any of them has thrown, which also ends the others' work.
     */
    RayCounts run(Renderer renderer) {
        HelperThreads threads = new HelperThreads();
        List<Worker> workers = new ArrayList<>();
        int count = renderer.settings().threads();
        start(isCold() ? Math.min(count, processorsWithoutOne()) : count, renderer, threads, workers);
        while (!threads.await(POLL_NANOSECONDS)) {
            if (cancellation.isRequested()) {
                threads.await(PATIENCE_NANOSECONDS);
                break;
            }
            if (!isCold()) {
                start(count, renderer, threads, workers);
            }
        }
        threads.rethrow();
        RayCounts counts = RayCounts.NONE;
        for (Worker worker : workers) {
            counts = counts.plus(worker.counts);
        }
        return counts;
    }

    private static boolean isCold() {
        return System.nanoTime() - FIRST_PASS < COLD_NANOSECONDS;
    }

    private static int processorsWithoutOne() {
        return Math.max(1, Runtime.getRuntime().availableProcessors() - 1);
    }

    /** Starts workers until there are so many. */
    private void start(int count, Renderer renderer, HelperThreads threads, List<Worker> workers) {
        while (workers.size() < count) {
            Worker worker = new Worker(new PixelLight(renderer));
            workers.add(worker);
            threads.start("tiles", worker);
        }
    }

    private final class Worker implements Runnable {
        private final PixelLight light;

        /** Of the tiles finished so far; also known of a thread that is too slow to be waited for. */
        private volatile RayCounts counts = RayCounts.NONE;

        Worker(PixelLight light) {
            this.light = light;
        }

        @Override
        public void run() {
            try {
                for (Optional<Region> next = tiles.next(); next.isPresent(); next = tiles.next()) {
                    Region tile = next.get();
                    light.beginTile();
                    drawTile(painter.paintedPixels(tile));
                    if (cancellation.isRequested()) {
                        return;
                    }
                    tiles.finish(tile);
                    counts = light.counts();
                    painter.finished(tile, light);
                }
            } finally {
                tiles.close();                   // after a failure, the other threads take no more
            }
        }

        private void drawTile(Region pixels) {
            for (int y = pixels.top(); y < pixels.bottom(); y++) {
                for (int x = pixels.left(); x < pixels.right() && !cancellation.isRequested(); x++) {
                    drawPixel(x, y);
                }
            }
        }

        private void drawPixel(int x, int y) {
            try {
                painter.paint(x, y, light);
            } catch (RuntimeException defect) {
                throw new IllegalStateException("pixel " + x + ", " + y + ": " + defect, defect);
            }
        }
    }
}
