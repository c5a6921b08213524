package raytracing.compiled;

import java.util.Arrays;
import raytracing.area.ConvexShadows;

/** The planes that some lines of a shaft cross and others do not. One thread, shaft after shaft. */
final class PlaneObstacles {
    private final PlaneArray planes;
    private int[] entry = new int[4];
    private int[] number = new int[4];
    private double[] gap = new double[4];
    private double[] middleGap = new double[4];
    private double[] alongU = new double[4];
    private double[] alongV = new double[4];
    private double[] doubt = new double[4];
    private int count;

    PlaneObstacles(PlaneArray planes) {
        this.planes = planes;
    }

    void clear() {
        count = 0;
    }

    int count() {
        return count;
    }

    /**
     * Finds out what a plane is to a shaft.
     *
     * @param gap how far the point is below the plane, in multiples of its normal
     * @param middleGap the same for the middle of the light
     * @param alongU what the gap loses for each step along the square's first axis
     * @param alongV what it loses along the second
     * @param doubt how far either gap may be off
     */
    void consider(ShadowShaft shaft, int surface, int i, double gap, double middleGap, double alongU, double alongV,
                  double doubt) {
        double spread = shaft.halfWidth * (Math.abs(alongU) + Math.abs(alongV));
        boolean sideIsKnown = Math.abs(gap) > doubt && Math.abs(middleGap) - spread > doubt;
        if (sideIsKnown) {
            if (gap > 0 != middleGap > 0) {
                shaft.certain.add(surface);
            }
            return;
        }
        if (count == entry.length) {
            grow();
        }
        entry[count] = i;
        number[count] = surface;
        this.gap[count] = Math.abs(gap) > doubt ? gap : -shaft.sideOf(surface);
        this.middleGap[count] = middleGap;
        this.alongU[count] = alongU;
        this.alongV[count] = alongV;
        this.doubt[count] = shaft.usesOwnCoordinates && this.gap[count] != 0 ? doubt : Double.POSITIVE_INFINITY;
        count++;
    }

    private void grow() {
        entry = Arrays.copyOf(entry, 2 * count);
        number = Arrays.copyOf(number, 2 * count);
        gap = Arrays.copyOf(gap, 2 * count);
        middleGap = Arrays.copyOf(middleGap, 2 * count);
        alongU = Arrays.copyOf(alongU, 2 * count);
        alongV = Arrays.copyOf(alongV, 2 * count);
        doubt = Arrays.copyOf(doubt, 2 * count);
    }

    /** Adds the shadows of these planes on the shaft's square: all beyond them, but for those that the point is on. */
    void addShadows(ConvexShadows shadows, double[] transmittanceOf) {
        for (int i = 0; i < count; i++) {
            if (gap[i] != 0) {
                double towards = gap[i] > 0 ? 1 : -1;
                shadows.beginFigure(transmittanceOf[number[i]]);
                shadows.addLine(towards * alongU[i], towards * alongV[i], -towards * middleGap[i]);
            }
        }
    }

    /** Adds the planes that the shaft's line to (x, y) of the light square crosses. */
    void addCrossed(ShadowShaft shaft, double x, double y) {
        for (int i = 0; i < count && !shaft.crossed.isDark(); i++) {
            double endGap = middleGap[i] - (x * alongU[i] + y * alongV[i]);
            boolean isCrossed = Math.abs(endGap) > doubt[i]
                ? gap[i] > 0 != endGap > 0 : planes.isCrossed(shaft, entry[i]);
            if (isCrossed) {
                shaft.crossed.add(number[i]);
            }
        }
    }
}
