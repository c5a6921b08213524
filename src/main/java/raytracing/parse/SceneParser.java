package raytracing.parse;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import raytracing.color.Color;
import raytracing.geometry.Box;
import raytracing.geometry.Plane;
import raytracing.geometry.Sphere;
import raytracing.geometry.Surface;
import raytracing.math.Vector;
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

    /** Keeps the numbers of the materials after a line that could not be read; never shown. */
    private static final Material NO_MATERIAL =
        new Material(Color.BLACK, Color.BLACK, Color.BLACK, 0, 0, Color.BLACK);

    /** Bytes of a file that are read at once. */
    private static final int PIECE = 1 << 16;

    private static final String UNKNOWN_CODE = "unknown code, expected cam, set, mtl, sph, pln, box or lgt";

    /** Codes as {@link SceneText#code} packs them. */
    private static final int CAM = 'c' << 16 | 'a' << 8 | 'm';
    private static final int SET = 's' << 16 | 'e' << 8 | 't';
    private static final int MTL = 'm' << 16 | 't' << 8 | 'l';
    private static final int SPH = 's' << 16 | 'p' << 8 | 'h';
    private static final int PLN = 'p' << 16 | 'l' << 8 | 'n';
    private static final int BOX = 'b' << 16 | 'o' << 8 | 'x';
    private static final int LGT = 'l' << 16 | 'g' << 8 | 't';

    private final Problems problems;
    private final Values values;
    private final List<Material> materials = new ArrayList<>();
    private final List<Surface> surfaces = new ArrayList<>();
    private final List<Light> lights = new ArrayList<>();
    private final List<MaterialAhead> materialsAhead = new ArrayList<>();
    private final Single<Camera> camera = new Single<>();
    private final Single<Settings> settings = new Single<>();

    /** A use of a material that no line has defined so far. */
    private record MaterialAhead(int line, String code, int number) {
    }

    /** An object that a scene has exactly one of. */
    private static final class Single<T> {
        private Optional<T> value = Optional.empty();
        private int line;
    }

    private SceneParser(String fileName, byte[] bytes) {
        problems = new Problems(fileName);
        values = new Values(new SceneText(bytes), problems);
    }

    /**
     * Reads a scene file.
     *
     * @param file where it is
     * @return the scene it describes
     * @throws RayTracerException if there is no such file, or whatever is wrong in it, up to 20 messages
     * @throws IOException if the file is there and cannot be read
     */
    public static Scene parseFile(Path file) throws RayTracerException, IOException {
        try {
            if (Files.isDirectory(file)) {
                throw new RayTracerException(file + ": is a folder, expected a scene file");
            }
            return parse(file.toString(), bytes(file));
        } catch (NoSuchFileException missing) {
            throw new RayTracerException(file + ": no such file, expected a scene file");
        }
    }

    /**
     * Large files in pieces: the library, asked for all of a file, makes a second copy of it outside the heap, which
     * took half as long again (53 instead of 36 ms for 33 MB). What has no size, as a pipe, is left to the library.
     */
    private static byte[] bytes(Path file) throws IOException {
        long size = Files.size(file);
        if (size <= PIECE || size > Integer.MAX_VALUE) {
            return Files.readAllBytes(file);
        }
        byte[] bytes = new byte[(int) size];
        int length = 0;
        try (InputStream stream = Files.newInputStream(file)) {
            int read = stream.read(bytes, 0, PIECE);
            while (read > 0) {
                length += read;
                read = stream.read(bytes, length, Math.min(PIECE, bytes.length - length));
            }
        }
        return length == bytes.length ? bytes : Arrays.copyOf(bytes, length);
    }

    /**
     * Reads the text of a scene.
     *
     * @param fileName what messages call it
     * @param bytes the text, as in a file
     * @return the scene it describes
     * @throws RayTracerException whatever is wrong in it, up to 20 messages
     */
    public static Scene parse(String fileName, byte[] bytes) throws RayTracerException {
        return new SceneParser(fileName, bytes).scene();
    }

    private Scene scene() throws RayTracerException {
        while (values.nextLine()) {
            readLine();
        }
        for (MaterialAhead ahead : materialsAhead) {
            checkDefined(ahead);
        }
        checkPresent(camera, "cam");
        checkPresent(settings, "set");
        problems.throwIfAny();
        return new Scene(camera.value.orElseThrow(), settings.value.orElseThrow(), materials, surfaces, lights);
    }

    private void readLine() {
        switch (values.code()) {
            case CAM -> readCamera();
            case SET -> readSettings();
            case MTL -> materials.add(isComplete(LineForm.MTL) ? material() : NO_MATERIAL);
            case SPH -> {
                if (isComplete(LineForm.SPH)) {
                    surfaces.add(sphere());
                }
            }
            case PLN -> {
                if (isComplete(LineForm.PLN)) {
                    surfaces.add(plane());
                }
            }
            case BOX -> {
                if (isComplete(LineForm.BOX)) {
                    surfaces.add(box());
                }
            }
            case LGT -> {
                if (isComplete(LineForm.LGT)) {
                    lights.add(light());
                }
            }
            default -> values.problem(UNKNOWN_CODE);
        }
    }

    /** Whether a line has as many values as its form; a problem if not. */
    private boolean isComplete(LineForm form) {
        boolean complete = form.allows(values.count());
        if (!complete) {
            values.problem(form.expectation() + ", got " + values.count() + form.surplus(values));
        }
        return complete;
    }

    private void readCamera() {
        if (isFirst(camera) && isComplete(LineForm.CAM)) {
            camera.value = Optional.of(camera());
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
            values.problem("one too many, the first is on line " + object.line + ", expected exactly one");
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

        private String surplus(Values found) {
            int most = counts[counts.length - 1];
            return found.count() > most ? ", first surplus value " + Printable.quote(found.token(most + 1)) : "";
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
            values.refuse("look-at", "another point than the position", shown(camera.lookAt()));
        } else if (up.isZero()) {
            values.refuse("up", "a direction, not zero", shown(up));
        } else if (camera.forward().cross(up.unit()).length() <= PARALLEL) {
            values.refuse("up", "at an angle to the view " + shown(camera.forward()), shown(up));
        }
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
        int problemsBefore = values.problemsFound();
        int number = values.wholeNumber("material", Range.WHOLE_FROM_1);
        if (number > materials.size() && values.problemsFound() == problemsBefore) {
            materialsAhead.add(new MaterialAhead(values.line(), values.token(0), number));
        }
        return number - 1;
    }

    private void checkDefined(MaterialAhead ahead) {
        int defined = materials.size();
        if (ahead.number > defined) {
            String expected = defined == 0 ? "that of a mtl line, and there is none" : "from 1 to " + defined;
            problems.add(ahead.line, ahead.code,
                Problems.refusal("material", expected, Integer.toString(ahead.number)));
        }
    }

    private void checkPresent(Single<?> object, String code) {
        if (object.line == 0) {
            problems.addForWholeFile(code, "missing, expected exactly one");
        }
    }
}
