package raytracing;

import java.io.PrintStream;
import java.util.Locale;
import javax.imageio.ImageIO;
import raytracing.render.RenderSettings;
import raytracing.trace.ShadowMode;

/**
 * The course's scenes, which may not be published here, and two sets of pictures of them: those that the course gave out,
 * and {@code expected}, by an independent renderer with the conventions of this one. They lie beside the checkout or are
 * missing.
 */
final class CourseScenes {
    private static final ShadowMode GLASS = ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT;
    private static final ShadowMode OPAQUE = ShadowMode.ALL_SURFACES_STOP_LIGHT;

    private CourseScenes() {
    }

    /** Draws a scene, 500 x 500 with seed 1, and compares it with a picture, a path in the folder. */
    static PictureDifference difference(String scene, ShadowMode shadowMode, String picture) throws Exception {
        RenderSettings settings = RenderSettings.DEFAULT.withShadowMode(shadowMode);
        return new PictureDifference(
            Steps.renderScene(Steps.parseScene(Shared.SCENES.resolve(scene + ".txt")), settings).toImage(),
            ImageIO.read(Shared.SCENES.resolve(picture).toFile()));
    }

    /**
     * Prints COURSE.md's table of differences.
     *
     * @param arguments none
     */
    public static void main(String[] arguments) throws Exception {
        PrintStream out = System.out;
        out.println("| scene | against the course's picture | against an independent renderer with our conventions |");
        out.println("|---|---|---|");
        row("Room1", "Room1", difference("Room1", GLASS, "Room1.png"), GLASS);
        row("Room1, fisheye", "Room1_fish", difference("Room1_fish", GLASS, "Room1_fish.png"), GLASS);
        row("Pool, N = 5", "Pool", difference("Pool", GLASS, "Pool.png"), GLASS);
        row("Spheres, N = 6, opaque shadows", "Spheres", difference("Spheres", OPAQUE, "Spheres.png"), OPAQUE);
        PictureDifference glass = difference("Spheres", GLASS, "expected/Spheres.png");
        out.println("| Spheres, N = 6 | the course has none | " + shown(glass) + " |");
    }

    private static void row(String title, String scene, PictureDifference course, ShadowMode shadowMode)
            throws Exception {
        String expected = "expected/" + scene + (shadowMode == OPAQUE ? "_opaque" : "") + ".png";
        System.out.println("| " + title + " | " + decibels(course) + " | "
            + shown(difference(scene, shadowMode, expected)) + " |");
    }

    private static String shown(PictureDifference difference) {
        return difference.shareOffByMoreThan(0) == 0 ? "identical"
            : decibels(difference) + ", mean difference " + String.format(Locale.ROOT, "%.3f", difference.mean())
                + " steps";
    }

    private static String decibels(PictureDifference difference) {
        return String.format(Locale.ROOT, "%.1f dB", difference.psnr());
    }
}
