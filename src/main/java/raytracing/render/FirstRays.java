package raytracing.render;

import raytracing.color.MutableColor;
import raytracing.film.Film;

/**
 * What the rays through the centres of the pixels see, before an {@link ErrorLimit} is met: their light, and numbers that tell
 * whether two rays saw the same things. A margin of one pixel around the part is looked at too, also beyond the picture; so
 * each pixel has eight neighbours, the same ones whatever part is drawn. Each pixel has one writer.
 */
final class FirstRays implements PixelPainter {
    /** The four lines of three pixels through a pixel: from its middle to one end, in columns and rows. */
    private static final int[] LINE_X = {1, 1, 0, -1};
    private static final int[] LINE_Y = {0, 1, 1, 1};

    private static final int CHANNELS = 3;

    private final Region part;
    private final Region filmed;
    private final Progress progress;
    private final DrawingListener listener;
    private final Film film;

    /** What each ray shows: three channels from 0 to 1. */
    private final float[] shown;

    /** Hash of the surfaces that the ray itself met. */
    private final int[] surfaces;

    /** Hash of all that it met, in mirrors too, and of the lights that reached it. */
    private final int[] details;
    private final boolean[] areMirrors;
    private final float[] highlightMargins;

    FirstRays(Region part, Progress progress, DrawingListener listener) {
        this.part = part;
        filmed = part.withMargin();
        this.progress = progress;
        this.listener = listener;
        film = new Film(part.width(), part.height());
        int pixels = (int) filmed.pixelCount();
        shown = new float[CHANNELS * pixels];
        surfaces = new int[pixels];
        details = new int[pixels];
        areMirrors = new boolean[pixels];
        highlightMargins = new float[pixels];
    }

    /** The part with its margin. */
    Region filmed() {
        return filmed;
    }

    @Override
    public void paint(int x, int y, PixelLight light) {
        MutableColor sum = light.ofOneRay(x, y);
        if (part.contains(x, y)) {
            film.set(x - part.left(), y - part.top(), sum.red(), sum.green(), sum.blue());
        }
        int i = index(x, y);
        shown[CHANNELS * i] = (float) Film.shown(sum.red());
        shown[CHANNELS * i + 1] = (float) Film.shown(sum.green());
        shown[CHANNELS * i + 2] = (float) Film.shown(sum.blue());
        surfaces[i] = Long.hashCode(light.directFingerprint());
        details[i] = Long.hashCode(light.detailFingerprint());
        areMirrors[i] = light.isMirrorSeen();
        highlightMargins[i] = (float) light.highlightMargin();
    }

    @Override
    public void finished(Region tile, PixelLight light) {
        Region drawn = tile.intersection(part);
        progress.addFirstRays(drawn.pixelCount());
        listener.showTile(drawn, film, part);
    }

    /** Of the part, with the light of the first rays. */
    Film film() {
        return film;
    }

    /** Finds what the neighbours tell about a pixel of the part. */
    void look(int x, int y, Neighbourhood result) {
        int own = index(x, y);
        result.begin(areMirrors[own], highlightMargins[own]);
        for (int line = 0; line < LINE_X.length; line++) {
            int next = LINE_Y[line] * filmed.width() + LINE_X[line];
            double ahead = compare(own, own + next, result);
            double behind = compare(own, own - next, result);
            if (ahead >= 0 && behind >= 0) {
                result.bend = Math.max(result.bend, bend(own - next, own, own + next));
            } else {
                result.isAtOutline = true;
                result.bend = Math.max(result.bend, Math.max(ahead, behind) / 2);
            }
        }
    }

    private int index(int x, int y) {
        return (y - filmed.top()) * filmed.width() + x - filmed.left();
    }

    /** Adds what a neighbour tells; returns the difference of light from it, or -1 if its ray met other surfaces. */
    private double compare(int own, int other, Neighbourhood result) {
        double contrast = contrast(own, other);
        result.contrast = Math.max(result.contrast, contrast);
        if (surfaces[other] != surfaces[own]) {
            return -1;
        }
        result.slope = Math.max(result.slope, contrast);
        result.hasDetail |= details[other] != details[own];
        double change = Math.abs(highlightMargins[own] - highlightMargins[other]);
        if (change > result.highlightChange) {   // false if it is NaN, as of two infinite ones
            result.highlightChange = change;
        }
        return contrast;
    }

    /** The largest difference of two pixels over the channels, in steps. */
    private double contrast(int pixel, int other) {
        double largest = 0;
        for (int channel = 0; channel < CHANNELS; channel++) {
            double difference = shown[CHANNELS * pixel + channel] - shown[CHANNELS * other + channel];
            largest = Math.max(largest, Math.abs(difference));
        }
        return PixelMean.STEPS * largest;
    }

    /** The largest second difference of three pixels over the channels, in steps. */
    private double bend(int before, int pixel, int after) {
        double largest = 0;
        for (int channel = 0; channel < CHANNELS; channel++) {
            double middle = shown[CHANNELS * pixel + channel];
            double bend = shown[CHANNELS * before + channel] - middle + (shown[CHANNELS * after + channel] - middle);
            largest = Math.max(largest, Math.abs(bend));
        }
        return PixelMean.STEPS * largest;
    }
}
