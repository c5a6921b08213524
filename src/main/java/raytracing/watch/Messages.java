package raytracing.watch;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.util.Locale;
import raytracing.color.Color;
import raytracing.film.ImageFormat;
import raytracing.parse.Printable;
import raytracing.render.Drawing;
import raytracing.render.Region;
import raytracing.render.RenderSettings;
import raytracing.shade.AmbientLight;

/**
 * What is said on standard error about a picture: one sentence when it begins, one when it ends, and one if a thread fails for
 * whose end no other one waits.
 */
public final class Messages implements Thread.UncaughtExceptionHandler {
    private static final long MILLION = 1_000_000;
    private static final long GIGABYTE = 1L << 30;

    /** From here on, seconds are easier to read. */
    private static final long MOST_MILLISECONDS = 9_999;

    private final String output;
    private final ImageFormat format;
    private final RenderSettings settings;
    private boolean isLossSaid;

    /**
     * Messages about a picture.
     *
     * @param output name of the file
     * @param format of the file
     * @param settings how it is drawn
     */
    public Messages(String output, ImageFormat format, RenderSettings settings) {
        this.output = output;
        this.format = format;
        this.settings = settings;
    }

    /**
     * The picture begins.
     *
     * @param scene name of the scene file
     * @return a sentence
     */
    public String begun(String scene) {
        return output + ": drawing " + pixels() + " of " + scene + " with " + settings.threads()
            + (settings.threads() == 1 ? " thread" : " threads");
    }

    /**
     * The file is there.
     *
     * @param drawing of the picture
     * @param ambientLight in which it was drawn
     * @param nanoseconds since the program began
     * @return a sentence
     */
    public String finished(Drawing drawing, AmbientLight ambientLight, long nanoseconds) {
        return output + ": " + pixels() + " in " + time(nanoseconds) + refinement(drawing) + ambience(ambientLight);
    }

    /**
     * Whether a whole picture shows no surface at all.
     *
     * @param drawing of the picture, finished
     * @return false for a part of a picture too, which may well show nothing
     */
    public boolean isOfNothing(Drawing drawing) {
        return drawing.counts().surfacesMet() == 0
            && settings.region().equals(Region.whole(settings.width(), settings.height()));
    }

    /**
     * No ray met anything.
     *
     * @param scene name of the scene file
     * @return a sentence
     */
    public static String nothingMet(String scene) {
        return scene + ": warning: no surface is in the picture; does the camera look towards them?";
    }

    private String pixels() {
        Region region = settings.region();
        String size = region.width() + " x " + region.height() + " pixels";
        return region.equals(Region.whole(settings.width(), settings.height())) ? size
            : size + " at " + region.left() + ", " + region.top() + " of " + settings.width() + " x " + settings.height();
    }

    private static String time(long nanoseconds) {
        long milliseconds = nanoseconds / MILLION;
        return milliseconds <= MOST_MILLISECONDS ? milliseconds + " ms" : milliseconds / 1000 + " s";
    }

    private String refinement(Drawing drawing) {
        int root = settings.sampling().root();
        return root == 1 ? "" : String.format(Locale.ROOT, ", %.1f %% of them with %d x %d rays",
            100.0 * drawing.refinedPixels() / settings.region().pixelCount(), root, root);
    }

    private static String ambience(AmbientLight light) {
        Color mean = light.mean();
        return light.isNone() ? "" : String.format(Locale.ROOT, ", in ambient light of %.3f %.3f %.3f",
            mean.red(), mean.green(), mean.blue());
    }

    /**
     * The file could not be written.
     *
     * @param failure why
     * @return a sentence that says what the file has now
     */
    public String failed(IOException failure) {
        return output + ": could not be written: " + reason(failure) + "; the file is as it was";
    }

    /**
     * Says, once, that a thread failed for whose end no other one waits. Such threads only show how far the picture is, which is
     * drawn all the same; the window's goes on after a failure and may fail each time it paints.
     *
     * @param thread that ended
     * @param thrown why
     */
    @Override
    public synchronized void uncaughtException(Thread thread, Throwable thrown) {
        if (!isLossSaid) {
            isLossSaid = true;
            System.err.println(output + ": drawing goes on without its thread " + thread.getName() + " (" + thrown + ")");
        }
    }

    /**
     * What is said if a file could not be read or written.
     *
     * @param failure why
     * @return the file, where one is known, and what is wrong with it
     */
    public static String sentence(IOException failure) {
        return Printable.of(failure instanceof FileSystemException file && file.getFile() != null
            ? file.getFile() + ": " + reason(failure) : reason(failure));
    }

    /**
     * What is said if the memory did not suffice. Virtual machines also call it memory if the system gives them no more
     * threads.
     *
     * @param error that was thrown
     * @return a sentence that says what to do
     */
    public static String shortage(OutOfMemoryError error) {
        return String.valueOf(error.getMessage()).contains("thread")
            ? "the system allows no more threads; --threads 1 needs the fewest"
            : "not enough memory for this scene and picture size; java -Xmx" + moreGigabytes() + "g -jar RayTracer.jar ... allows "
                + moreGigabytes() + " GB";
    }

    /** Twice what there was, and no less than 4. */
    private static long moreGigabytes() {
        long there = (Runtime.getRuntime().maxMemory() - 1) / GIGABYTE + 1;
        return Math.max(4, 2 * there);
    }

    /**
     * What is said if this program is wrong.
     *
     * @param defect that was thrown
     * @return a sentence
     */
    public static String defect(Throwable defect) {
        return "this is a defect of the program, please report it: " + defect;
    }

    /**
     * Why a file could not be read or written.
     *
     * @param thrown whose own message is often the file's name alone, or that of a library which was told by another one
     * @return what is wrong, without the file's name
     */
    public static String reason(IOException thrown) {
        IOException failure = thrown;
        while (failure.getCause() instanceof IOException cause) {
            failure = cause;
        }
        if (failure instanceof FileSystemException file && file.getFile() != null) {
            return file.getReason() == null ? kind(failure) : file.getReason();
        }
        return failure.getMessage() == null ? kind(failure) : failure.getMessage();
    }

    /** {@code AccessDeniedException} becomes "access denied". */
    private static String kind(IOException failure) {
        String name = failure.getClass().getSimpleName().replace("Exception", "");
        return name.replaceAll("(?<=.)(?=[A-Z])", " ").toLowerCase(Locale.ROOT);
    }

    /**
     * The picture was cancelled.
     *
     * @param drawing of the picture
     * @return a sentence that says what the file has now
     */
    public String stopped(Drawing drawing) {
        String share = output + ": stopped at " + (int) (100 * drawing.share()) + " %, ";
        if (drawing.isPartial()) {
            return share + "what was finished is in the file; the rest is "
                + (format.showsGaps(drawing) ? "transparent" : "in the colour of the background");
        }
        return share + "the file is as it was";
    }
}
