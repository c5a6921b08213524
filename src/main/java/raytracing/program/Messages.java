package raytracing.program;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Locale;
import raytracing.ambient.AmbientLight;
import raytracing.color.Color;
import raytracing.film.Comparison;
import raytracing.film.DifferenceMap;
import raytracing.film.ImageFormat;
import raytracing.render.Drawing;
import raytracing.render.ErrorTally;
import raytracing.render.PixelGrid;
import raytracing.render.Region;
import raytracing.render.RenderSettings;

/** The sentences about one picture, from the first to the summary. */
public record Messages(String output, ImageFormat format, RenderSettings settings) {
    private static final long MILLION = 1_000_000;

    /** Longer times are given in seconds. */
    private static final long MOST_MILLISECONDS = 9_999;

    String begun(String scene) {
        return output + ": drawing " + pixels() + " of " + scene + " with " + settings.threads()
            + (settings.threads() == 1 ? " thread" : " threads");
    }

    /** The summary of a whole picture that took some nanoseconds since the program began. */
    String finished(Drawing drawing, AmbientLight ambientLight, long nanoseconds) {
        long milliseconds = nanoseconds / MILLION;
        String time = milliseconds <= MOST_MILLISECONDS ? milliseconds + " ms" : milliseconds / 1000 + " s";
        return output + ": " + pixels() + " in " + time + refinement(drawing, ambientLight) + ambience(ambientLight);
    }

    /** Why a picture is not whole, and what its file contains now. */
    String stopped(Drawing drawing) {
        String share = output + ": stopped at " + (int) (100 * drawing.progress().share()) + " %, ";
        return share + (!drawing.isPartial() ? "the file is as it was" : "what was finished is in the file; the rest is "
            + (format.showsGaps(drawing) ? "transparent" : "in the colour of the background"));
    }

    /** Why a picture that is not whole is not compared. */
    String notCompared(String file) {
        return output + ": not compared with " + file + ", as the picture is not whole";
    }

    /** How far the picture is from that of a file; the figures are easily found by programs. */
    String compared(String file, Comparison comparison) {
        return output + ": compared with " + file + ": RMS " + figure(comparison.rootMeanSquare()) + " steps, PSNR "
            + decibels(comparison.psnr()) + " dB, largest difference " + comparison.largest() + " of 255, "
            + figure(100 * comparison.shareOff()) + " % of the pixels off by more than 1 step";
    }

    static String mapped(String map) {
        return map + ": where the pictures differ: " + DifferenceMap.LEGEND;
    }

    /** Four digits from the first that is not 0, so that no difference looks like none. */
    static String figure(double number) {
        return new BigDecimal(number).round(new MathContext(4)).toPlainString();
    }

    /** Two decimals, or Infinity. */
    static String decibels(double number) {
        return fixed(number, 2);
    }

    /** A number with some decimals, ties upwards; or Infinity. String.format would load 260 classes for the same text. */
    private static String fixed(double number, int decimals) {
        return Double.isInfinite(number) ? String.valueOf(number)
            : BigDecimal.valueOf(number).setScale(decimals, RoundingMode.HALF_UP).toPlainString();
    }

    /** Whether a finished picture shows no surface; false for a region of a picture, which may well show none. */
    public boolean isOfNothing(Drawing drawing) {
        return drawing.counts().surfacesMet() == 0 && isWhole();
    }

    static String nothingMet(String scene) {
        return scene + ": warning: no surface is in the picture; does the camera look towards them?";
    }

    private boolean isWhole() {
        return settings.region().pixelCount() == (long) settings.width() * settings.height();
    }

    private String pixels() {
        Region region = settings.region();
        String size = region.width() + " x " + region.height() + " pixels";
        return isWhole() ? size
            : size + " at " + region.left() + ", " + region.top() + " of " + settings.width() + " x " + settings.height();
    }

    private String refinement(Drawing drawing, AmbientLight ambientLight) {
        if (!(settings.sampling() instanceof PixelGrid grid)) {
            return errors(drawing, ambientLight);
        }
        int root = grid.root();
        return root == 1 ? "" : ", " + fixed(refined(drawing), 1) + " % of them with " + root + " x " + root + " rays";
    }

    private double refined(Drawing drawing) {
        return 100.0 * drawing.progress().refined() / settings.region().pixelCount();
    }

    /** What came out under an error limit. */
    private String errors(Drawing drawing, AmbientLight ambientLight) {
        ErrorTally errors = drawing.errors();
        String ambient = ambientLight.isNone() ? "" : ", ambient light about " + steps(ambientLight.error()) + " steps";
        String sentence = ", error about " + steps(errors.error()) + " steps (largest " + steps(errors.largest()) + ")" + ambient
            + ", " + fixed(refined(drawing), 0) + " % of the pixels with more than one ray";
        if (errors.unfinished() > 0) {
            sentence += ", " + errors.unfinished() + " of them need more than " + ErrorTally.mostRays()
                + " rays and may be off by up to " + steps(errors.largestUnfinished()) + " steps";
        }
        return sentence + (format.isLossy() ? ", and " + format.name().toLowerCase(Locale.ROOT) + " itself loses more" : "");
    }

    private static String steps(double error) {
        return fixed(error, error < 0.1 ? 2 : 1);
    }

    private static String ambience(AmbientLight light) {
        Color mean = light.mean();
        return light.isNone() ? "" : ", in ambient light of " + fixed(mean.red(), 3) + " " + fixed(mean.green(), 3) + " "
            + fixed(mean.blue(), 3);
    }
}
