package raytracing.watch;

import java.io.IOException;
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
    private static final Path PROCESS = Path.of("/proc/self/status");
    private static final String PEAK_RESIDENT = "VmHWM:";
    private static final long KILO = 1024;

    private final Map<String, Map<String, Figure>> groups = new LinkedHashMap<>();

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
        statistics.addRays(drawing.counts(), renderer.ambientLight().pathCount());
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

    private Map<String, Figure> group(String name) {
        Map<String, Figure> group = new LinkedHashMap<>();
        groups.put(name, group);
        return group;
    }

    private void addScene(String file, Scene scene, Renderer renderer) {
        Map<String, Figure> group = group("scene");
        group.put("file", new Figure.Name(file));
        group.put("spheres", count(scene, Sphere.class));
        group.put("planes", count(scene, Plane.class));
        group.put("boxes", count(scene, Box.class));
        group.put("materials", new Figure.Count(scene.materials().size()));
        group.put("lights", new Figure.Count(scene.lights().size()));
        if (!renderer.ambientLight().isNone()) {
            Color mean = renderer.ambientLight().mean();
            group.put("ambient light", new Figure.Numbers(List.of(mean.red(), mean.green(), mean.blue())));
            group.put("ambient places", new Figure.Count(renderer.ambientLight().placeCount()));
        }
    }

    private static Figure count(Scene scene, Class<? extends Surface> kind) {
        long count = 0;
        for (Surface surface : scene.surfaces()) {
            count += kind.isInstance(surface) ? 1 : 0;
        }
        return new Figure.Count(count);
    }

    private void addPicture(RenderSettings settings, Drawing drawing) {
        Map<String, Figure> group = group("picture");
        Region region = settings.region();
        group.put("width", new Figure.Count(settings.width()));
        group.put("height", new Figure.Count(settings.height()));
        group.put("region", new Figure.Numbers(
            List.of(region.left(), region.top(), region.width(), region.height())));
        group.put("bands", new Figure.Count(drawing.count()));
        group.put("threads", new Figure.Count(settings.threads()));
        group.put("share drawn", Figure.Share.of(drawing.finishedPixels(), region.pixelCount()));
        group.put("share of pixels smoothed", Figure.Share.of(drawing.refinedPixels(), region.pixelCount()));
    }

    private void addRays(RayCounts counts, long ambientPaths) {
        Map<String, Figure> rays = group("rays");
        rays.put("from the eye", new Figure.Count(counts.eye()));
        rays.put("mirrored", new Figure.Count(counts.mirrored()));
        rays.put("surfaces met by both", new Figure.Count(counts.surfacesMet()));
        rays.put("to lights", new Figure.Count(counts.shadowRays()));
        rays.put("shadows by areas", new Figure.Count(counts.shadowAreas()));
        rays.put("paths of ambient light", new Figure.Count(ambientPaths));
        Map<String, Figure> culled = group("culled");
        culled.put("mirrored rays too faint to be seen", Figure.Share.of(counts.mirroredLeftOut(),
            counts.mirrored() + counts.mirroredLeftOut()));
        culled.put("lights that a surface does not show", Figure.Share.of(counts.lightsAtPoints() - counts.lightsAsked(),
            counts.lightsAtPoints()));
        culled.put("other lights whose shadow needed no ray", Figure.Share.of(counts.lightsSettled(), counts.lightsAsked()));
    }

    private void addTimes(Renderer renderer, Drawing drawing, Times times) {
        Map<String, Figure> group = group("milliseconds");
        group.put("reading the scene", new Figure.Milliseconds(times.parsingNanoseconds));
        group.put("arranging its surfaces", new Figure.Milliseconds(renderer.compilingNanoseconds()));
        group.put("ambient light", new Figure.Milliseconds(renderer.ambientNanoseconds()));
        group.put("drawing", new Figure.Milliseconds(drawing.nanoseconds()));
        group.put("writing the file", new Figure.Milliseconds(times.writingNanoseconds - drawing.nanoseconds()));
        group.put("all", new Figure.Milliseconds(times.totalNanoseconds));
    }

    /** All memory of the process that was resident at once, where the system says it. */
    private void addMemory() {
        for (String line : linesOf(PROCESS)) {
            if (line.startsWith(PEAK_RESIDENT)) {
                long kilobytes = Long.parseLong(line.replaceAll("\\D", ""));
                group("bytes").put("peak of the process", new Figure.Count(KILO * kilobytes));
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
     * @return a table with a line for each figure
     */
    public String text() {
        StringBuilder text = new StringBuilder();
        for (Map.Entry<String, Map<String, Figure>> group : groups.entrySet()) {
            text.append(group.getKey()).append(System.lineSeparator());
            for (Map.Entry<String, Figure> figure : group.getValue().entrySet()) {
                text.append(String.format(Locale.ROOT, "  %-42s %s%n", figure.getKey(), figure.getValue().text()));
            }
        }
        return text.toString();
    }

    /**
     * For programs.
     *
     * @return a JSON object (RFC 8259) in one line, with an object for each group
     */
    public String json() {
        List<String> members = new ArrayList<>();
        for (Map.Entry<String, Map<String, Figure>> group : groups.entrySet()) {
            List<String> figures = new ArrayList<>();
            for (Map.Entry<String, Figure> figure : group.getValue().entrySet()) {
                figures.add(member(figure.getKey(), figure.getValue().json()));
            }
            members.add(member(group.getKey(), object(figures)));
        }
        return object(members) + System.lineSeparator();
    }

    private static String member(String name, String value) {
        return Figure.quoted(name.replace(' ', '_')) + ": " + value;
    }

    private static String object(List<String> members) {
        return "{" + String.join(", ", members) + "}";
    }
}
