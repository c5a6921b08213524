package raytracing.report;

import java.awt.image.BufferedImage;

/**
 * Structural similarity as Wang, Bovik, Sheikh and Simoncelli define it (Image Quality Assessment: From Error
 * Visibility to Structural Similarity, IEEE Transactions on Image Processing 13, 2004): of luminance, in a Gaussian
 * window of 11 x 11 pixels, and its mean over all windows that lie wholly in the picture.
 */
final class Ssim {
    /** Edge of the window in pixels, and so of the smallest picture. */
    static final int WINDOW = 11;

    private static final double SIGMA = 1.5;
    private static final double C1 = square(0.01 * 255);
    private static final double C2 = square(0.03 * 255);
    private static final double[] WEIGHTS = weights();

    private final double[][] first;
    private final double[][] second;

    private Ssim(BufferedImage first, BufferedImage second) {
        this.first = luminance(first);
        this.second = luminance(second);
    }

    /** Mean similarity of two pictures of the same size: 1 where they are equal, less elsewhere. */
    static double mean(BufferedImage first, BufferedImage second) {
        if (first.getWidth() != second.getWidth() || first.getHeight() != second.getHeight()) {
            throw new IllegalArgumentException("pictures of different sizes");
        }
        if (first.getWidth() < WINDOW || first.getHeight() < WINDOW) {
            throw new IllegalArgumentException("a picture smaller than the window");
        }
        return new Ssim(first, second).mean();
    }

    private static double square(double x) {
        return x * x;
    }

    /** Of a row of the window; a pixel's weight is that of its column times that of its row. */
    private static double[] weights() {
        double[] weights = new double[WINDOW];
        double sum = 0;
        for (int i = 0; i < WINDOW; i++) {
            weights[i] = Math.exp(-square(i - WINDOW / 2) / (2 * square(SIGMA)));
            sum += weights[i];
        }
        for (int i = 0; i < WINDOW; i++) {
            weights[i] /= sum;
        }
        return weights;
    }

    /** Luma of ITU-R BT.601, from the 8 bits as they are shown. */
    private static double[][] luminance(BufferedImage picture) {
        double[][] rows = new double[picture.getHeight()][picture.getWidth()];
        for (int y = 0; y < picture.getHeight(); y++) {
            for (int x = 0; x < picture.getWidth(); x++) {
                int color = picture.getRGB(x, y);
                rows[y][x] = 0.299 * (color >> 16 & 0xff) + 0.587 * (color >> 8 & 0xff) + 0.114 * (color & 0xff);
            }
        }
        return rows;
    }

    private double mean() {
        int across = first[0].length - WINDOW + 1;
        int down = first.length - WINDOW + 1;
        double sum = 0;
        for (int y = 0; y < down; y++) {
            for (int x = 0; x < across; x++) {
                sum += window(x, y);
            }
        }
        return sum / ((double) across * down);
    }

    private double window(int left, int top) {
        double a = 0;
        double b = 0;
        double aa = 0;
        double bb = 0;
        double ab = 0;
        for (int y = 0; y < WINDOW; y++) {
            for (int x = 0; x < WINDOW; x++) {
                double weight = WEIGHTS[y] * WEIGHTS[x];
                double p = first[top + y][left + x];
                double q = second[top + y][left + x];
                a += weight * p;
                b += weight * q;
                aa += weight * p * p;
                bb += weight * q * q;
                ab += weight * p * q;
            }
        }
        double variances = aa - a * a + bb - b * b;
        double covariance = ab - a * b;
        return (2 * a * b + C1) * (2 * covariance + C2) / ((a * a + b * b + C1) * (variances + C2));
    }
}
