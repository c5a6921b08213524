package raytracing.watch;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import raytracing.color.Color;
import raytracing.geometry.Box;
import raytracing.geometry.Plane;
import raytracing.geometry.Sphere;
import raytracing.geometry.Surface;
import raytracing.render.Drawing;
import raytracing.render.Region;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.scene.Scene;
import raytracing.shade.RayCounts;

/**
 * What a picture took: named groups of named figures, as a table for people or as JSON for programs. Counts are whole
 * numbers, shares go from 0 to 1, times are in milliseconds, memory is in bytes.
 */
public final class Statistics {
    private static final double MILLI = 1e-6;
    private static final Path PROCESS = Path.of("/proc/self/status");
    private static final String PEAK_RESIDENT = "VmHWM:";
    private static final long KILO = 1024;

    private final Map<String, Map<String, Object>> groups = new LinkedHashMap<>();

    private Statistics() {
    }

    /**
     * Collects the figures of a picture that was drawn and written.
     *
     * @param sceneFile where the scene came from
     * @param scene what was drawn
     * @param settings how
     * @param renderer by whom
     * @param drawing the picture
     * @param times how long the steps around it took
     * @return its statistics
     */
    public static Statistics of(String sceneFile, Scene scene, RenderSettings settings, Renderer renderer,
                                Drawing drawing, Times times) {
        Statistics statistics = new Statistics();
        statistics.addScene(sceneFile, scene, renderer);
        statistics.addPicture(settings, drawing);
        statistics.addRays(drawing.counts());
        statistics.addTimes(renderer, drawing, times);
        statistics.addMemory();
        return statistics;
    }

    /**
     * How long some steps took.
     *
     * @param parsingNanoseconds reading the scene, wall time
     * @param writingNanoseconds drawing and writing the picture
     * @param totalNanoseconds from the start of the program's own code to its end
     */
    public record Times(long parsingNanoseconds, long writingNanoseconds, long totalNanoseconds) {
    }

    private Map<String, Object> group(String name) {
        Map<String, Object> group = new LinkedHashMap<>();
        groups.put(name, group);
        return group;
    }

    private void addScene(String file, Scene scene, Renderer renderer) {
        Map<String, Object> group = group("scene");
        group.put("file", file);
        group.put("spheres", count(scene, Sphere.class));
        group.put("planes", count(scene, Plane.class));
        group.put("boxes", count(scene, Box.class));
        group.put("materials", scene.materials().size());
        group.put("lights", scene.lights().size());
        if (!renderer.ambientLight().isNone()) {
            Color mean = renderer.ambientLight().mean();
            group.put("ambient light", List.of(mean.red(), mean.green(), mean.blue()));
            group.put("ambient places", renderer.ambientLight().placeCount());
        }
    }

    private static int count(Scene scene, Class<? extends Surface> kind) {
        int count = 0;
        for (Surface surface : scene.surfaces()) {
            count += kind.isInstance(surface) ? 1 : 0;
        }
        return count;
    }

    private void addPicture(RenderSettings settings, Drawing drawing) {
        Map<String, Object> group = group("picture");
        Region region = settings.region();
        group.put("width", settings.width());
        group.put("height", settings.height());
        group.put("region", List.of(region.left(), region.top(), region.width(), region.height()));
        group.put("bands", drawing.count());
        group.put("threads", settings.threads());
        group.put("share drawn", drawing.share());
        group.put("share of pixels smoothed", (double) drawing.refinedPixels() / region.pixelCount());
    }

    private void addRays(RayCounts counts) {
        Map<String, Object> rays = group("rays");
        rays.put("from the eye", counts.eye());
        rays.put("mirrored", counts.mirrored());
        rays.put("surfaces met by both", counts.surfacesMet());
        rays.put("to lights", counts.shadowRays());
        rays.put("shadows by areas", counts.shadowAreas());
        Map<String, Object> culled = group("culled");
        culled.put("mirrored rays too faint to be seen", share(counts.mirroredLeftOut(),
            counts.mirrored() + counts.mirroredLeftOut()));
        culled.put("lights that a surface faces away from", share(counts.lightsAtPoints() - counts.lightsAsked(),
            counts.lightsAtPoints()));
        culled.put("other lights whose shadow needed no ray", share(counts.lightsSettled(), counts.lightsAsked()));
    }

    private static double share(long part, long whole) {
        return whole == 0 ? 0 : (double) part / whole;
    }

    private void addTimes(Renderer renderer, Drawing drawing, Times times) {
        Map<String, Object> group = group("milliseconds");
        group.put("reading the scene", MILLI * times.parsingNanoseconds);
        group.put("arranging its surfaces", MILLI * renderer.compilingNanoseconds());
        group.put("ambient light", MILLI * renderer.ambientNanoseconds());
        group.put("drawing", MILLI * drawing.nanoseconds());
        group.put("writing the file", MILLI * (times.writingNanoseconds - drawing.nanoseconds()));
        group.put("all", MILLI * times.totalNanoseconds);
    }

    /** Java's own objects, and all of the process where the system says it. */
    private void addMemory() {
        Map<String, Object> group = group("bytes");
        long heap = 0;
        for (MemoryPoolMXBean pool : ManagementFactory.getMemoryPoolMXBeans()) {
            if (pool.getType() == MemoryType.HEAP) {
                heap += pool.getPeakUsage().getUsed();
            }
        }
        group.put("peak of the heap", heap);
        for (String line : linesOf(PROCESS)) {
            if (line.startsWith(PEAK_RESIDENT)) {
                group.put("peak of the process", KILO * Long.parseLong(line.replaceAll("\\D", "")));
            }
        }
    }

    private static List<String> linesOf(Path file) {
        try {
            return Files.readAllLines(file);
        } catch (IOException notLinux) {
            return List.of();
        }
    }

    /**
     * For people.
     *
     * @return a table of lines, with a line for each figure
     */
    public String text() {
        StringBuilder text = new StringBuilder();
        for (Map.Entry<String, Map<String, Object>> group : groups.entrySet()) {
            text.append(group.getKey()).append(System.lineSeparator());
            boolean areShares = group.getKey().equals("culled");
            for (Map.Entry<String, Object> figure : group.getValue().entrySet()) {
                boolean isShare = areShares || figure.getKey().startsWith("share");
                text.append(String.format(Locale.ROOT, "  %-42s %s%n", figure.getKey(),
                    isShare ? String.format(Locale.ROOT, "%.1f %%", 100 * (Double) figure.getValue())
                        : readable(figure.getValue())));
            }
        }
        return text.toString();
    }

    private static String readable(Object value) {
        if (value instanceof List<?> list) {
            List<String> parts = new ArrayList<>();
            for (Object part : list) {
                parts.add(readable(part));
            }
            return String.join(" ", parts);
        }
        if (value instanceof Double number) {
            return String.format(Locale.ROOT, number < 10 ? "%.3f" : "%.0f", number);
        }
        return value instanceof Long number ? String.format(Locale.ROOT, "%,d", number) : value.toString();
    }

    /**
     * For programs.
     *
     * @return a JSON object (RFC 8259) in one line, with an object for each group
     */
    public String json() {
        return json(groups) + System.lineSeparator();
    }

    private static String json(Object value) {
        if (value instanceof Map<?, ?> map) {
            List<String> members = new ArrayList<>();
            for (Map.Entry<?, ?> member : map.entrySet()) {
                members.add(json(((String) member.getKey()).replace(' ', '_')) + ": " + json(member.getValue()));
            }
            return "{" + String.join(", ", members) + "}";
        }
        if (value instanceof List<?> list) {
            List<String> elements = new ArrayList<>();
            for (Object element : list) {
                elements.add(json(element));
            }
            return "[" + String.join(", ", elements) + "]";
        }
        return value instanceof String text ? quoted(text) : value.toString();
    }

    private static String quoted(String text) {
        StringBuilder quoted = new StringBuilder("\"");
        for (char c : text.toCharArray()) {
            if (c == '"' || c == '\\') {
                quoted.append('\\').append(c);
            } else if (c < ' ') {
                quoted.append(String.format(Locale.ROOT, "\\u%04x", (int) c));
            } else {
                quoted.append(c);
            }
        }
        return quoted.append('"').toString();
    }
}
