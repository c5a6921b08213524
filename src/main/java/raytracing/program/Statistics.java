package raytracing.program;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import raytracing.ambient.AmbientLight;
import raytracing.color.Color;
import raytracing.film.Comparison;
import raytracing.parse.Printable;
import raytracing.render.Drawing;
import raytracing.render.ErrorLimit;
import raytracing.render.ErrorTally;
import raytracing.render.Region;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.scene.Scene;
import raytracing.shade.RayCounts;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

/**
 * What a picture took: named groups of named values, as a table or as JSON. Counts are whole numbers, shares go from 0 to 1
 * (in the table, percents), times are in milliseconds, memory is in bytes.
 */
final class Statistics {
    private static final Path PROCESS = Path.of("/proc/self/status");
    private static final String PEAK_RESIDENT = "VmHWM:";
    private static final long KILO = 1024;
    private static final double MILLION = 1e6;

    private final StringBuilder text = new StringBuilder();
    private final StringBuilder json = new StringBuilder("{");

    /** Wall times in nanoseconds: reading the scene, drawing and writing the picture, and all since the program began. */
    record Times(long parsing, long writing, long total) {
    }

    /** The statistics of a picture that is drawn and written. */
    Statistics(String sceneFile, Scene scene, RenderSettings settings, Renderer renderer, Drawing drawing, Times times) {
        addScene(sceneFile, scene, renderer.ambientLight());
        addPicture(settings, drawing);
        if (settings.sampling() instanceof ErrorLimit limit) {
            addErrors(limit, drawing.errors(), renderer.ambientLight());
        }
        addRays(drawing.counts(), renderer.ambientLight().pathCount());
        addTimes(renderer, drawing, times);
        addMemory();
    }

    /** Begins another group. */
    private void begin(String name) {
        text.append(name).append(System.lineSeparator());
        json.append(json.length() == 1 ? "" : "}, ").append(quoted(name)).append(": {");
    }

    /** Adds a value to the group in both forms. */
    private void add(String name, String forTable, String forJson) {
        text.append(String.format(Locale.ROOT, "  %-42s %s%n", name, forTable));
        boolean isFirst = json.charAt(json.length() - 1) == '{';
        json.append(isFirst ? "" : ", ").append(quoted(name.replace(' ', '_'))).append(": ").append(forJson);
    }

    private void addCount(String name, long count) {
        add(name, String.format(Locale.ROOT, "%,d", count), String.valueOf(count));
    }

    /** A part of a whole; 0 of an empty whole. */
    private void addShare(String name, long part, long whole) {
        double share = whole == 0 ? 0 : (double) part / whole;
        add(name, String.format(Locale.ROOT, "%.1f %%", 100 * share), String.valueOf(share));
    }

    private void addTime(String name, long nanoseconds) {
        double milliseconds = nanoseconds / MILLION;
        add(name, String.format(Locale.ROOT, "%,.1f", milliseconds), String.valueOf(milliseconds));
    }

    private void addScene(String file, Scene scene, AmbientLight ambientLight) {
        begin("scene");
        add("file", Printable.of(file), quoted(file));
        Kinds kinds = new Kinds();
        for (Surface surface : scene.surfaces()) {
            surface.accept(kinds);
        }
        addCount("spheres", kinds.spheres);
        addCount("planes", kinds.planes);
        addCount("boxes", kinds.boxes);
        addCount("triangles", kinds.triangles);
        addCount("materials", scene.materials().size());
        addCount("lights", scene.lights().size());
        if (!ambientLight.isNone()) {
            Color mean = ambientLight.mean();
            add("ambient light", String.format(Locale.ROOT, "%.3f %.3f %.3f", mean.red(), mean.green(), mean.blue()),
                List.of(mean.red(), mean.green(), mean.blue()).toString());
            addCount("ambient places", ambientLight.recordCount());
        }
    }

    /** Counts the surfaces of each kind that it visits. */
    private static final class Kinds implements Surface.Visitor<Long> {
        private long spheres;
        private long planes;
        private long boxes;
        private long triangles;

        @Override
        public Long visit(Sphere sphere) {
            return ++spheres;
        }

        @Override
        public Long visit(Plane plane) {
            return ++planes;
        }

        @Override
        public Long visit(Box box) {
            return ++boxes;
        }

        @Override
        public Long visit(Triangle triangle) {
            return ++triangles;
        }
    }

    private void addPicture(RenderSettings settings, Drawing drawing) {
        begin("picture");
        Region region = settings.region();
        List<Integer> sides = List.of(region.left(), region.top(), region.width(), region.height());
        addCount("width", settings.width());
        addCount("height", settings.height());
        add("region", sides.get(0) + " " + sides.get(1) + " " + sides.get(2) + " " + sides.get(3), sides.toString());
        addCount("bands", drawing.count());
        addCount("threads", settings.threads());
        addShare("share drawn", drawing.progress().finished(), region.pixelCount());
        addShare("share of pixels smoothed", drawing.progress().refined(), region.pixelCount());
    }

    /** How many rays the pixels got under an error limit, and the errors that are left, in steps of 1/255. */
    private void addErrors(ErrorLimit limit, ErrorTally errors, AmbientLight ambientLight) {
        begin("error");
        addSteps("limit", limit.steps());
        addSteps("estimate", errors.error());
        addSteps("largest estimate", errors.largest());
        if (!ambientLight.isNone()) {
            addSteps("estimate of ambient light", ambientLight.error());
        }
        for (int level = 0; level < ErrorTally.levels(); level++) {
            int rays = ErrorTally.rays(level);
            addCount("pixels with " + rays + (rays == 1 ? " ray" : " rays"), errors.pixelsAt(level));
        }
        addCount("pixels whose rays ran out", errors.unfinished());
        addSteps("largest estimate of those", errors.largestUnfinished());
    }

    private void addSteps(String name, double steps) {
        add(name, String.format(Locale.ROOT, "%.2f", steps), String.valueOf(steps));
    }

    private void addRays(RayCounts counts, long ambientPaths) {
        begin("rays");
        addCount("from the eye", counts.eye());
        addCount("mirrored", counts.mirrored());
        addCount("surfaces met by both", counts.surfacesMet());
        addCount("to lights", counts.shadowRays());
        addCount("shadows by areas", counts.shadowAreas());
        addCount("paths of ambient light", ambientPaths);
        begin("culled");
        addShare("mirrored rays too faint to be seen", counts.mirroredLeftOut(),
            counts.mirrored() + counts.mirroredLeftOut());
        addShare("lights that a surface does not show", counts.lightsAtPoints() - counts.shadowQueries(),
            counts.lightsAtPoints());
        addShare("other lights whose shadow needed no ray", counts.lightsSettled(), counts.shadowQueries());
    }

    private void addTimes(Renderer renderer, Drawing drawing, Times times) {
        begin("milliseconds");
        addTime("reading the scene", times.parsing);
        addTime("arranging its surfaces", renderer.arrangingNanoseconds());
        addTime("ambient light", renderer.ambientNanoseconds());
        addTime("drawing", drawing.nanoseconds());
        addTime("writing the file", times.writing - drawing.nanoseconds());
        addTime("all", times.total);
    }

    /** The largest memory that was resident at once; only on Linux. */
    private void addMemory() {
        try {
            for (String line : Files.readAllLines(PROCESS)) {
                if (line.startsWith(PEAK_RESIDENT)) {
                    begin("bytes");
                    addCount("peak of the process", KILO * Long.parseLong(line.replaceAll("\\D", "")));
                }
            }
        } catch (IOException notLinux) {
            // the group is left out
        }
    }

    /** Adds how far the picture is from that of a file. JSON has no infinity: there, the PSNR of equal pictures is null. */
    void addComparison(String file, Comparison comparison) {
        begin("comparison");
        add("file", Printable.of(file), quoted(file));
        add("RMS in steps", Messages.figure(comparison.rootMeanSquare()), String.valueOf(comparison.rootMeanSquare()));
        double psnr = comparison.psnr();
        add("PSNR in dB", Messages.decibels(psnr), Double.isInfinite(psnr) ? "null" : String.valueOf(psnr));
        addCount("largest difference in steps", comparison.largest());
        addShare("share of pixels off by more than a step", comparison.off(), comparison.pixels());
    }

    /** A table with a line for each value. */
    String text() {
        return text.toString();
    }

    /** A JSON object (RFC 8259) on one line, with an object for each group. */
    String json() {
        return json + "}}" + System.lineSeparator();
    }

    /** A JSON string. */
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
