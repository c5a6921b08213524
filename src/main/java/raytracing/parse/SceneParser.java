package raytracing.parse;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import raytracing.color.Color;
import raytracing.math.Vector;
import raytracing.parallel.ForkJoin;
import raytracing.scene.Camera;
import raytracing.scene.Fisheye;
import raytracing.scene.Lens;
import raytracing.scene.Light;
import raytracing.scene.Material;
import raytracing.scene.Pinhole;
import raytracing.scene.Scene;
import raytracing.scene.Settings;
import raytracing.surface.Surface;

/**
 * Reads a scene file; {@code src/docs/FORMAT.md} is its user's manual. It refuses instead of guessing: everything that is not
 * as the manual says gets one line that names file, line number, code, value and what was expected. One parser reads one file.
 */
public final class SceneParser {
    private static final double DEFAULT_FISHEYE_K = 0.5;
    private static final double DEFAULT_AMBIENT_SCALE = 1;
    private static final Range SHADOW_RAY_ROOTS = Range.whole(1, Settings.LARGEST_SHADOW_RAY_ROOT);
    private static final Range RECURSIONS = Range.whole(0, 1000);

    /**
     * An up vector within this sine of the view counts as parallel to it: a million times the rounding of a direction
     * between two points whose coordinates are written with the usual digits, and a thousandth of what could be meant.
     */
    private static final double PARALLEL = 1e-10;

    private static final int MOST_ERRORS_LISTED = 20;
    private static final int MOST_WARNINGS_LISTED = 10;

    /** After so many lines it reports how much is read: so rarely that it costs nothing. */
    private static final int LINES_UNTIL_REPORT = 1 << 12;

    /** So many bytes are read by one thread: more than what mostly stands before the surfaces, and than most files have. */
    private static final int FIRST_BYTES = 1 << 16;

    /** So many bytes of the rest make a part, long enough that handing it to another thread costs far less than reading it. */
    private static final int BYTES_OF_A_PART = 1 << 19;

    private final String fileName;
    private final SceneText text;
    private final Findings problems;
    private final Findings warnings;
    private final Values values;
    private final SceneWarnings sceneWarnings = new SceneWarnings();
    private final List<Material> materials = new ArrayList<>();
    private final List<Surface> surfaces = new ArrayList<>();
    private final List<Light> lights = new ArrayList<>();
    private final Single<Camera> camera = new Single<>();
    private final Single<Settings> settings = new Single<>();
    private final ForkJoin workers;
    private int linesRead;
    private int bytesReported;
    private int unknownLines;
    private int materialCount;
    private int largestMaterial;

    /** An object that a scene has exactly one of. */
    private static final class Single<T> {
        private Optional<T> value = Optional.empty();
        private int line;
    }

    private SceneParser(String fileName, byte[] bytes, ForkJoin workers) {
        this.fileName = fileName;
        this.workers = workers;
        text = new SceneText(bytes);
        problems = new Findings(fileName, MOST_ERRORS_LISTED);
        warnings = new Findings(fileName, MOST_WARNINGS_LISTED);
        values = new Values(text, problems, warnings);
    }

    /**
     * Reads a scene file and reports how many of its bytes are read.
     *
     * @param workers threads that read a long file; the result is the same
     * @throws RayTracerException if there is no such file, or its errors, up to 20 messages
     * @throws IOException if the file is there and cannot be read
     */
    public static ParsedScene parseFile(Path file, ForkJoin workers) throws RayTracerException, IOException {
        return parse(file.toString(), SceneFile.bytes(file), workers);
    }

    /**
     * Reads the bytes of a scene file, which messages call {@code fileName}.
     *
     * @param workers threads that read a long file; the result is the same
     * @throws RayTracerException its errors, up to 20 messages
     */
    public static ParsedScene parse(String fileName, byte[] bytes, ForkJoin workers) throws RayTracerException {
        return parse(fileName, bytes, workers, FIRST_BYTES, BYTES_OF_A_PART);
    }

    /** The same with other places at which the file is divided. */
    static ParsedScene parse(String fileName, byte[] bytes, ForkJoin workers, int firstBytes, int bytesOfAPart)
            throws RayTracerException {
        workers.expect(bytes.length);
        return new SceneParser(fileName, bytes, workers).parsed(firstBytes, bytesOfAPart);
    }

    private ParsedScene parsed(int firstBytes, int bytesOfAPart) throws RayTracerException {
        readLines(Math.min(firstBytes, text.length()));
        for (SurfaceLines lines : aheadOfTheRest(bytesOfAPart)) {
            if (lines.arePlain()) {
                addAll(lines);
            } else {
                readLines(lines.end());
            }
        }
        if (largestMaterial > materialCount) {
            checkMaterials();
        }
        checkPresent(camera, "cam");
        checkPresent(settings, "set");
        if (!problems.isEmpty()) {
            throw refusal();
        }
        Scene scene = new Scene(camera.value.orElseThrow(), settings.value.orElseThrow(), materials, surfaces, lights);
        addWarnings(scene);
        return new ParsedScene(scene, warnings.listed());
    }

    /** Reads all lines that begin before a place. */
    private void readLines(int end) {
        while (values.nextLine(end)) {
            linesRead++;
            readLine();
            if (linesRead % LINES_UNTIL_REPORT == 0) {
                workers.advance(text.bytesRead() - bytesReported);
                bytesReported = text.bytesRead();
            }
        }
    }

    /** Lets all processors read what is left, if it is much, as if it were nothing but surfaces. */
    private List<SurfaceLines> aheadOfTheRest(int bytesOfAPart) {
        List<SurfaceLines> all = new ArrayList<>();
        int start = text.bytesRead();
        while (start < text.length()) {
            int end = text.lineStart(Math.min(text.length() - start, bytesOfAPart) + start);
            all.add(new SurfaceLines(text.part(start, end), sceneWarnings.ofAPart(), materialCount));
            start = end;
        }
        if (all.size() > 1) {
            workers.runRanges(0, all.size(), 1, (from, to) -> all.get(from).read(workers));
        }
        return all;
    }

    /** Adds the surfaces of lines that were read ahead, as if they had been read here. */
    private void addAll(SurfaceLines lines) {
        linesRead += lines.linesRead();
        largestMaterial = Math.max(largestMaterial, lines.largestMaterial());
        if (problems.isEmpty()) {
            sceneWarnings.addAll(lines.warnings(), lines.surfaces(), surfaces.size());
            surfaces.addAll(lines.surfaces());
        }
        text.skip(lines.text());
        bytesReported = text.bytesRead();
    }

    private void addWarnings(Scene scene) {
        sceneWarnings.addTo(warnings, scene, settings.line);
        int around = sceneWarnings.bodyAroundTheEye(scene);
        if (around >= 0) {
            warnings.add(lineOfSurface(around), "warning: " + text.token(0)
                + ": the camera is inside, the material is opaque, and no lgt is inside");
        }
    }

    /** Reads the file once more up to a surface, given by its index in the scene, as line numbers are not kept. */
    private int lineOfSurface(int index) {
        text.rewind();
        int reached = -1;
        while (reached < index && values.nextLine()) {
            reached += text.isCompleteSurface() ? 1 : 0;
        }
        return text.lineNumber();
    }

    /** The exception to be thrown; a file without any code may be no scene file at all. */
    private RayTracerException refusal() {
        Optional<String> kind = unknownLines == linesRead ? OtherFile.kind(text) : Optional.empty();
        return kind.isEmpty() ? new RayTracerException(problems.listed())
            : new RayTracerException(fileName + ": is " + kind.get() + ", expected a scene file in UTF-8");
    }

    private void readLine() {
        Code code = text.code();
        switch (code) {
            case CAM -> readCamera();
            case SET -> readSettings();
            case MTL -> readMaterial();
            case SPH, PLN, BOX, TRG -> readSurface(code);
            case LGT -> readLight();
            case UNKNOWN -> {
                unknownLines++;
                values.problem(() -> UnknownCode.message(text.token(0)));
            }
        }
    }

    // Java evaluates arguments from left to right, so each constructor reads its values in the order of the line.

    private void readCamera() {
        if (isFirst(camera) && values.isComplete(Code.CAM)) {
            Camera read = new Camera(values.vector("position"), values.vector("look-at"), values.vector("up"),
                values.number("screen distance", Range.ABOVE_0), values.number("screen width", Range.ABOVE_0), lens());
            if (values.problemsFound() == 0) {
                checkView(read);
            }
            camera.value = Optional.of(read);
            sceneWarnings.setEye(read.position(), surfaces);
        }
    }

    private Lens lens() {
        boolean fisheye = values.hasMore() && values.flag("fisheye");
        double k = values.hasMore() ? values.number("k", Range.FROM_MINUS_1_TO_1) : DEFAULT_FISHEYE_K;
        return fisheye ? new Fisheye(k) : new Pinhole();
    }

    private void readSettings() {
        if (isFirst(settings) && values.isComplete(Code.SET)) {
            settings.value = Optional.of(new Settings(values.color("background"),
                values.wholeNumber("shadow ray root", SHADOW_RAY_ROOTS), values.wholeNumber("maximum recursion", RECURSIONS),
                values.hasMore() ? values.number("ambient scale", Range.AT_LEAST_0) : DEFAULT_AMBIENT_SCALE));
        }
    }

    private void readMaterial() {
        materialCount++;
        if (values.isComplete(Code.MTL)) {
            Material material = new Material(values.color("diffuse"), values.color("specular"), values.color("reflection"),
                values.number("Phong exponent", Range.AT_LEAST_0), values.number("transparency", Range.FROM_0_TO_1),
                values.hasMore() ? values.color("ambient") : Color.BLACK);
            if (problems.isEmpty()) {
                sceneWarnings.addMaterial(material);
                materials.add(material);
            }
        }
    }

    /** Keeps nothing of a scene with errors: it will not be drawn, and a million wrong lines need no memory. */
    private void readSurface(Code code) {
        if (values.isComplete(code)) {
            Surface surface = values.surface(code);
            largestMaterial = Math.max(largestMaterial, surface.material() + 1);
            if (problems.isEmpty()) {
                sceneWarnings.addSurface(surface, surfaces.size(), materialCount);
                surfaces.add(surface);
            }
        }
    }

    private void readLight() {
        if (values.isComplete(Code.LGT)) {
            Light light = new Light(values.vector("position"), values.color("colour"),
                values.number("specular intensity", Range.AT_LEAST_0), values.number("shadow intensity", Range.FROM_0_TO_1),
                values.number("width", Range.AT_LEAST_0));
            if (problems.isEmpty()) {
                lights.add(light);
            }
        }
    }

    /** Whether no earlier line has the object; reports a problem if one has. */
    private boolean isFirst(Single<?> object) {
        boolean first = object.line == 0;
        if (first) {
            object.line = text.lineNumber();
        } else {
            values.problem(() -> "one too many, the first is on line " + object.line + ", expected exactly one");
        }
        return first;
    }

    private void checkView(Camera camera) {
        Vector up = camera.up();
        if (camera.position().minus(camera.lookAt()).isZero()) {
            String other = camera.position().isZero() ? "0 0 1" : "0 0 0";
            values.refuse("look-at", "another point than the position, such as " + other, Values.shown(camera.lookAt()));
        } else if (up.isZero()) {
            values.refuse("up", "a direction, not zero, such as " + upFor(camera.forward()), Values.shown(up));
        } else if (camera.forward().cross(up.unit()).length() <= PARALLEL) {
            values.refuse("up", "at an angle to the view " + Values.shown(camera.forward()) + ", such as "
                + upFor(camera.forward()), Values.shown(up));
        }
    }

    /** The axis that is most nearly perpendicular to a view; of several, y before z before x. */
    private static String upFor(Vector forward) {
        double x = Math.abs(forward.x());
        double y = Math.abs(forward.y());
        double z = Math.abs(forward.z());
        if (y <= z && y <= x) {
            return "0 1 0";
        }
        return z <= x ? "0 0 1" : "1 0 0";
    }

    /** Reads the file once more, as line numbers are not kept, and reports every surface whose material no line has. */
    private void checkMaterials() {
        String expected = materialCount == 0 ? "that of a mtl line, and there is none" : "from 1 to " + materialCount;
        text.rewind();
        while (values.nextLine()) {
            int last = text.count() - 1;
            if (text.isCompleteSurface() && text.decimal(last) > materialCount
                    && Range.WHOLE_FROM_1.contains(text.decimal(last))) {
                values.refuse("material", expected, Integer.toString((int) text.decimal(last)));
            }
        }
    }

    private void checkPresent(Single<?> object, String code) {
        if (object.line == 0) {
            problems.add(Findings.WHOLE_FILE, code + ": missing, expected exactly one");
        }
    }
}
