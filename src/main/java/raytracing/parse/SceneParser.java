package raytracing.parse;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import raytracing.color.Color;
import raytracing.geometry.Box;
import raytracing.geometry.Plane;
import raytracing.geometry.Sphere;
import raytracing.geometry.Surface;
import raytracing.math.Vector;
import raytracing.progress.Preparation;
import raytracing.scene.Camera;
import raytracing.scene.Fisheye;
import raytracing.scene.Lens;
import raytracing.scene.Light;
import raytracing.scene.Material;
import raytracing.scene.Pinhole;
import raytracing.scene.Scene;
import raytracing.scene.Settings;

/**
 * Reads a scene file; {@code src/docs/FORMAT.md} is its user's manual. Refuses instead of guessing: whatever is not
 * as the manual says becomes one line naming file, line number, code, value and what was expected. One parser reads
 * one file.
 */
public final class SceneParser {
    private static final double DEFAULT_FISHEYE_K = 0.5;
    private static final double DEFAULT_AMBIENT_SCALE = 1;
    private static final Range SHADOW_RAY_ROOTS = Range.whole(1, 1024);
    private static final Range RECURSIONS = Range.whole(0, 1000);

    /**
     * An up vector within this sine of the view counts as parallel to it: a million times the rounding of a direction
     * between two points whose coordinates are written with the usual digits, and a thousandth of what could be meant.
     */
    private static final double PARALLEL = 1e-10;

    private static final int MOST_ERRORS_LISTED = 20;
    private static final int MOST_WARNINGS_LISTED = 10;

    /** After so many lines it tells how far it is: rarely enough to cost nothing. */
    private static final int LINES_UNTIL_TOLD = 1 << 12;

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
    private final Preparation preparation;
    private int linesRead;
    private int bytesTold;
    private int unknownLines;
    private int materialCount;
    private int largestMaterial;

    /** An object that a scene has exactly one of. */
    private static final class Single<T> {
        private Optional<T> value = Optional.empty();
        private int line;
    }

    private SceneParser(String fileName, byte[] bytes, Preparation preparation) {
        this.fileName = fileName;
        this.preparation = preparation;
        text = new SceneText(bytes);
        problems = new Findings(fileName, MOST_ERRORS_LISTED);
        warnings = new Findings(fileName, MOST_WARNINGS_LISTED);
        values = new Values(text, problems, warnings);
    }

    /**
     * Reads a scene file.
     *
     * @param file where it is
     * @return the scene it describes, and warnings
     * @throws RayTracerException if there is no such file, or whatever is wrong in it, up to 20 messages
     * @throws IOException if the file is there and cannot be read
     */
    public static ParsedScene parseFile(Path file) throws RayTracerException, IOException {
        return parseFile(file, new Preparation());
    }

    /**
     * Reads a scene file while another thread asks how far it is.
     *
     * @param file where it is
     * @param preparation is told
     * @return the scene it describes, and warnings
     * @throws RayTracerException if there is no such file, or whatever is wrong in it, up to 20 messages
     * @throws IOException if the file is there and cannot be read
     */
    public static ParsedScene parseFile(Path file, Preparation preparation) throws RayTracerException, IOException {
        return parse(file.toString(), SceneFile.bytes(file), preparation);
    }

    /**
     * Reads the text of a scene while another thread may ask how far it is.
     *
     * @param fileName what messages call it
     * @param bytes the text, as in a file
     * @param preparation is told
     * @return the scene it describes, and warnings
     * @throws RayTracerException whatever is wrong in it, up to 20 messages
     */
    public static ParsedScene parse(String fileName, byte[] bytes, Preparation preparation) throws RayTracerException {
        preparation.expect(bytes.length);
        return new SceneParser(fileName, bytes, preparation).parsed();
    }

    private ParsedScene parsed() throws RayTracerException {
        while (values.nextLine()) {
            linesRead++;
            readLine();
            if (linesRead % LINES_UNTIL_TOLD == 0) {
                tellHowFar();
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

    private void addWarnings(Scene scene) {
        sceneWarnings.addTo(warnings, scene, settings.line);
        int around = sceneWarnings.bodyAroundTheEye(scene);
        if (around >= 0) {
            warnings.add(lineOfSurface(around), "warning: " + values.token(0)
                + ": the camera is inside, the material is opaque, and no lgt is inside");
        }
    }

    /** Reads the file once more up to a surface, given by its place in the scene: where it stands was not kept. */
    private int lineOfSurface(int place) {
        values.rewind();
        int reached = -1;
        while (reached < place && values.nextLine()) {
            reached += isCompleteSurface() ? 1 : 0;
        }
        return values.line();
    }

    private boolean isCompleteSurface() {
        return switch (values.code()) {
            case Codes.SPH -> LineForm.SPH.allows(values.count());
            case Codes.PLN -> LineForm.PLN.allows(values.count());
            case Codes.BOX -> LineForm.BOX.allows(values.count());
            default -> false;
        };
    }

    /** A file without any code may be something else altogether. */
    private RayTracerException refusal() {
        Optional<String> kind = unknownLines == linesRead ? OtherFile.kind(text) : Optional.empty();
        return kind.isEmpty() ? new RayTracerException(problems.listed())
            : new RayTracerException(fileName + ": is " + kind.get() + ", expected a scene file in UTF-8");
    }

    private void tellHowFar() {
        int bytes = text.bytesRead();
        preparation.advance(bytes - bytesTold);
        bytesTold = bytes;
    }

    private void readLine() {
        switch (values.code()) {
            case Codes.CAM -> readCamera();
            case Codes.SET -> readSettings();
            case Codes.MTL -> readMaterial();
            case Codes.SPH -> {
                if (isComplete(LineForm.SPH)) {
                    add(sphere());
                }
            }
            case Codes.PLN -> {
                if (isComplete(LineForm.PLN)) {
                    add(plane());
                }
            }
            case Codes.BOX -> {
                if (isComplete(LineForm.BOX)) {
                    add(box());
                }
            }
            case Codes.LGT -> readLight();
            default -> {
                unknownLines++;
                values.problem(() -> UnknownCode.message(values.token(0)));
            }
        }
    }

    /** Of a scene with errors nothing is kept: it will not be drawn, and a million wrong lines need no memory. */
    private void add(Surface surface) {
        if (problems.isEmpty()) {
            sceneWarnings.addSurface(surface, surfaces.size());
            surfaces.add(surface);
        }
    }

    private void readMaterial() {
        materialCount++;
        if (isComplete(LineForm.MTL)) {
            Material material = material();
            if (problems.isEmpty()) {
                sceneWarnings.addMaterial();
                materials.add(material);
            }
        }
    }

    private void readLight() {
        if (isComplete(LineForm.LGT)) {
            Light light = light();
            if (problems.isEmpty()) {
                lights.add(light);
            }
        }
    }

    /** Whether a line has as many values as its form; a problem if not. */
    private boolean isComplete(LineForm form) {
        boolean complete = form.allows(values.count());
        if (!complete) {
            values.problem(() -> form.expectation() + ", got " + values.count() + form.surplus(values)
                + Hint.about(values.tokens(), form.most()));
        }
        return complete;
    }

    private void readCamera() {
        if (isFirst(camera) && isComplete(LineForm.CAM)) {
            Camera read = camera();
            camera.value = Optional.of(read);
            sceneWarnings.setEye(read.position(), surfaces);
        }
    }

    private void readSettings() {
        if (isFirst(settings) && isComplete(LineForm.SET)) {
            settings.value = Optional.of(settings());
        }
    }

    /** Whether no line before this one has the object; a problem if one has. */
    private boolean isFirst(Single<?> object) {
        boolean first = object.line == 0;
        if (first) {
            object.line = values.line();
        } else {
            values.problem(() -> "one too many, the first is on line " + object.line + ", expected exactly one");
        }
        return first;
    }

    /** How many values follow a code, the counts in rising order, and what they are. */
    private enum LineForm {
        CAM("position 3, look-at 3, up 3, screen distance, screen width, [fisheye], [k]", 11, 12, 13),
        SET("background 3, shadow ray root, maximum recursion, [ambient scale]", 5, 6),
        MTL("diffuse 3, specular 3, reflection 3, Phong exponent, transparency, [ambient 3]", 11, 14),
        SPH("centre 3, radius, material", 5),
        PLN("normal 3, offset, material", 5),
        BOX("centre 3, edge, material", 5),
        LGT("position 3, colour 3, specular intensity, shadow intensity, width", 9);

        private final String values;
        private final int[] counts;

        LineForm(String values, int... counts) {
            this.values = values;
            this.counts = counts;
        }

        private boolean allows(int count) {
            for (int allowed : counts) {
                if (allowed == count) {
                    return true;
                }
            }
            return false;
        }

        private String expectation() {
            StringBuilder alternatives = new StringBuilder();
            for (int i = 0; i < counts.length; i++) {
                String separator = i == 0 ? "" : i == counts.length - 1 ? " or " : ", ";
                alternatives.append(separator).append(counts[i]);
            }
            return "expected " + alternatives + " values (" + values + ")";
        }

        private int most() {
            return counts[counts.length - 1];
        }

        private String surplus(Values found) {
            return found.count() > most() ? ", first surplus value " + Printable.quote(found.token(most() + 1)) : "";
        }
    }

    private Camera camera() {
        Vector position = values.vector("position");
        Vector lookAt = values.vector("look-at");
        Vector up = values.vector("up");
        double screenDistance = values.number("screen distance", Range.ABOVE_0);
        double screenWidth = values.number("screen width", Range.ABOVE_0);
        boolean fisheye = values.hasMore() && values.flag("fisheye");
        double k = values.hasMore() ? values.number("k", Range.FROM_MINUS_1_TO_1) : DEFAULT_FISHEYE_K;
        Lens lens = fisheye ? new Fisheye(k) : new Pinhole();
        Camera camera = new Camera(position, lookAt, up, screenDistance, screenWidth, lens);
        if (values.problemsFound() == 0) {
            checkView(camera);
        }
        return camera;
    }

    private void checkView(Camera camera) {
        Vector up = camera.up();
        if (camera.position().minus(camera.lookAt()).isZero()) {
            String other = camera.position().isZero() ? "0 0 1" : "0 0 0";
            values.refuse("look-at", "another point than the position, such as " + other, shown(camera.lookAt()));
        } else if (up.isZero()) {
            values.refuse("up", "a direction, not zero, such as " + upFor(camera.forward()), shown(up));
        } else if (camera.forward().cross(up.unit()).length() <= PARALLEL) {
            values.refuse("up", "at an angle to the view " + shown(camera.forward()) + ", such as "
                + upFor(camera.forward()), shown(up));
        }
    }

    /** The axis that is most nearly perpendicular to a view: of several, y before z before x. */
    private static String upFor(Vector forward) {
        double x = Math.abs(forward.x());
        double y = Math.abs(forward.y());
        double z = Math.abs(forward.z());
        if (y <= z && y <= x) {
            return "0 1 0";
        }
        return z <= x ? "0 0 1" : "1 0 0";
    }

    private static String shown(Vector vector) {
        return vector.x() + " " + vector.y() + " " + vector.z();
    }

    private Settings settings() {
        Color background = values.color("background");
        int shadowRayRoot = values.wholeNumber("shadow ray root", SHADOW_RAY_ROOTS);
        int maxReflections = values.wholeNumber("maximum recursion", RECURSIONS);
        double ambientScale = values.hasMore()
            ? values.number("ambient scale", Range.AT_LEAST_0) : DEFAULT_AMBIENT_SCALE;
        return new Settings(background, shadowRayRoot, maxReflections, ambientScale);
    }

    private Material material() {
        Color diffuse = values.color("diffuse");
        Color specular = values.color("specular");
        Color reflection = values.color("reflection");
        double phongExponent = values.number("Phong exponent", Range.AT_LEAST_0);
        double transparency = values.number("transparency", Range.FROM_0_TO_1);
        Color ambient = values.hasMore() ? values.color("ambient") : Color.BLACK;
        return new Material(diffuse, specular, reflection, phongExponent, transparency, ambient);
    }

    private Sphere sphere() {
        Vector centre = values.vector("centre");
        double radius = values.number("radius", Range.ABOVE_0);
        return new Sphere(centre, radius, materialIndex());
    }

    private Plane plane() {
        Vector normal = values.vector("normal");
        if (normal.isZero()) {
            values.refuse("normal", "a direction, not zero", shown(normal));
        }
        double offset = values.number("offset", Range.ANY);
        return new Plane(normal, offset, materialIndex());
    }

    private Box box() {
        Vector centre = values.vector("centre");
        double edge = values.number("edge", Range.ABOVE_0);
        return new Box(centre, edge, materialIndex());
    }

    private Light light() {
        Vector position = values.vector("position");
        Color color = values.color("colour");
        double specularIntensity = values.number("specular intensity", Range.AT_LEAST_0);
        double shadowIntensity = values.number("shadow intensity", Range.FROM_0_TO_1);
        double width = values.number("width", Range.AT_LEAST_0);
        return new Light(position, color, specularIntensity, shadowIntensity, width);
    }

    /** The material's place in the list, from 0. Its line may still be ahead. */
    private int materialIndex() {
        int number = values.wholeNumber("material", Range.WHOLE_FROM_1);
        largestMaterial = Math.max(largestMaterial, number);
        return number - 1;
    }

    /** Reads all surfaces once more if one names a material that no line has: where they stand was not kept. */
    private void checkMaterials() {
        String expected = materialCount == 0 ? "that of a mtl line, and there is none" : "from 1 to " + materialCount;
        values.rewind();
        while (values.nextLine()) {
            int last = values.count();
            if (isCompleteSurface() && values.decimal(last) > materialCount
                    && Range.WHOLE_FROM_1.containsWhole(values.decimal(last))) {
                values.refuse("material", expected, Integer.toString((int) values.decimal(last)));
            }
        }
    }

    private void checkPresent(Single<?> object, String code) {
        if (object.line == 0) {
            problems.addForWholeFile(code + ": missing, expected exactly one");
        }
    }
}
