package raytracing.report;

import java.awt.image.BufferedImage;

/**
 * False colours for errors, on a logarithmic scale from white over ever darker colours: the cubehelix of Green (A
 * colour scheme for the display of astronomical intensity images, Bulletin of the Astronomical Society of India 39,
 * 2011) with its own start, turns and hue, read from its bright end. Its brightness alone tells the order, also in grey
 * and to the colour-blind.
 */
final class ColorScale {
    /** Shown white, with all that is less. */
    static final double LEAST = 1e-4;

    /** Shown darkest, with all that is more. */
    static final double MOST = 1;

    /** Black would leave no colour to tell the largest errors apart. */
    private static final double DARKEST = 0.1;

    private static final double START = 0.5;
    private static final double TURNS = -1.5;

    private ColorScale() {
    }

    /** The colour of an error, as 24 bits. */
    static int color(double error) {
        double position = Math.log(Math.max(error, LEAST) / LEAST) / Math.log(MOST / LEAST);
        return cubehelix(1 - (1 - DARKEST) * Math.min(position, 1));
    }

    /** Brightness runs from 0 for black to 1 for white. */
    private static int cubehelix(double brightness) {
        double angle = 2 * Math.PI * (START / 3 + 1 + TURNS * brightness);
        double amplitude = brightness * (1 - brightness) / 2;
        double cos = amplitude * Math.cos(angle);
        double sin = amplitude * Math.sin(angle);
        return channel(brightness - 0.14861 * cos + 1.78277 * sin) << 16
            | channel(brightness - 0.29227 * cos - 0.90649 * sin) << 8
            | channel(brightness + 1.97294 * cos);
    }

    private static int channel(double value) {
        return (int) Math.round(255 * Math.min(Math.max(value, 0), 1));
    }

    /** All colours in their order, the least error on the left. */
    static BufferedImage legend(int width, int height) {
        BufferedImage legend = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int x = 0; x < width; x++) {
            int color = color(LEAST * Math.pow(MOST / LEAST, (x + 0.5) / width));
            for (int y = 0; y < height; y++) {
                legend.setRGB(x, y, color);
            }
        }
        return legend;
    }
}
