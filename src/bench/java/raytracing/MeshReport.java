package raytracing;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.ref.Reference;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import raytracing.parse.RayTracerException;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Renderers;
import raytracing.scene.Scene;

/**
 * Writes into PERFORMANCE.md what a triangle of a large mesh takes before the first ray, beside a ball of a large sphereflake:
 * reading, arranging, and the heap that is then in use. On one thread, by its processor time.
 */
public final class MeshReport {
    private static final Path DOCUMENT = Path.of("src", "docs", "PERFORMANCE.md");
    private static final String PART = "meshes";
    private static final int RUNS = 5;
    private static final int COLLECTIONS = 3;

    private MeshReport() {
    }

    /** What one scene takes, the first time in this virtual machine and the last. */
    private record Cost(String title, double firstRead, double lastRead, double firstArrange, double lastArrange, double heap) {
    }

    public static void main(String[] arguments) throws IOException, RayTracerException {
        Path folder = Files.createTempDirectory("meshes");
        try {
            List<List<String>> rows = new ArrayList<>();
            for (TimedScene scene : List.of(TimedScene.KNOT_1000000, TimedScene.FLAKE_597871)) {
                Cost cost = cost(scene.title(), scene.file(folder));
                rows.add(List.of(cost.title, pair(cost.firstRead, cost.lastRead, "%.1f"),
                    pair(cost.firstArrange, cost.lastArrange, "%.0f"), String.format(Locale.ROOT, "%.0f", cost.heap)));
            }
            MeasuredPart.replace(DOCUMENT, PART, "\n" + Machine.origin("gradle meshes") + "\n\n" + MarkdownTable.of(
                List.of("scene", "reading, ns a byte", "arranging, ns a surface", "heap, bytes a surface"), rows));
        } finally {
            MeasuredProcess.delete(folder);
        }
    }

    private static String pair(double first, double last, String format) {
        return String.format(Locale.ROOT, format + ", " + format, first, last);
    }

    private static Cost cost(String title, Path file) throws IOException, RayTracerException {
        double bytes = Files.size(file);
        double[] reads = new double[RUNS];
        double[] arranges = new double[RUNS];
        double heap = 0;
        for (int i = 0; i < RUNS; i++) {
            long before = usedHeap();
            long start = processorTime();
            Scene scene = Steps.parseScene(file);
            long read = processorTime();
            Renderer renderer = Renderers.of(scene, RenderSettings.DEFAULT.withWorkers(1, RenderSettings.DEFAULT_TILE_SIZE));
            long arranged = processorTime();
            int surfaces = scene.surfaces().size();
            reads[i] = (read - start) / bytes;
            arranges[i] = (double) (arranged - read) / surfaces;
            heap = (double) (usedHeap() - before) / surfaces;
            Reference.reachabilityFence(renderer);       // so that the heap is measured with it
            Reference.reachabilityFence(scene);
        }
        return new Cost(title, reads[0], reads[RUNS - 1], arranges[0], arranges[RUNS - 1], heap);
    }

    private static long processorTime() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    }

    private static long usedHeap() {
        for (int i = 0; i < COLLECTIONS; i++) {
            System.gc();
        }
        return ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed();
    }
}
