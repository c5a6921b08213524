package raytracing.compiled;

import java.util.Arrays;

/**
 * The spheres that some lines of a shaft cross and others may not. One thread, shaft after shaft.
 *
 * <p>With m the way from the shaded point to the centre, in the shaft's coordinates, and e the line's end, the line meets the
 * sphere if (m . e)^2 &gt;= (m . m - r r)(e . e): its cosine to the axis of the cone around the sphere is large enough. That
 * is a product and a sum less than the world's coordinates need, which also have to be found first.
 */
final class SphereObstacles {
    private static final double ALWAYS_IN_DOUBT = Double.POSITIVE_INFINITY;
    private static final int UNKNOWN = 0;

    /** 64 u, with u = 2^-53: axes that are off by 8 ulp, twice, and what rounding takes from the squares. */
    private static final double POWER_ERROR = 0x1p-47;

    private final SphereArray spheres;
    private int[] entry = new int[8];
    private int[] number = new int[8];
    private double[] across = new double[8];
    private double[] up = new double[8];
    private double[] ahead = new double[8];
    private double[] power = new double[8];
    private double[] doubt = new double[8];

    /** Of a sphere that the hit touches, 1 if it does so from outside and -1 from inside; {@link #UNKNOWN} of others. */
    private int[] side = new int[8];
    private int count;

    SphereObstacles(SphereArray spheres) {
        this.spheres = spheres;
    }

    void clear() {
        count = 0;
    }

    int count() {
        return count;
    }

    /**
     * Finds out what a sphere is to a shaft that it may touch.
     *
     * @param mx way from the point to the centre, in the shaft's coordinates, x part
     * @param my y part
     * @param mz z part
     * @param r radius
     * @param slack by how much the sphere may be larger or smaller, rounding of all sides included
     */
    void consider(ShadowShaft shaft, int surface, int i, double mx, double my, double mz, double r, double slack) {
        double grown = r + slack;
        double squaredDistance = mx * mx + my * my + mz * mz;
        boolean isApart = squaredDistance > grown * grown && mz + grown < shaft.depth;
        double power = squaredDistance - r * r;
        if (isApart ? hidesSquare(shaft, mx, my, mz, squaredDistance, r - slack)
                : separatesSquare(shaft, mx, my, mz, squaredDistance, grown, r - slack)) {
            shaft.certain.add(surface);
        } else if (isApart) {
            double error = squaredDistance * shaft.cornerDistance
                * (ShadowShaft.ROUNDING * shaft.cornerDistance + 4 * shaft.margin);
            add(surface, i, mx, my, mz * shaft.depth, power, shaft.usesOwnCoordinates ? error : ALWAYS_IN_DOUBT, UNKNOWN);
        } else if (!isAround(shaft, mx, my, mz, squaredDistance, r - slack)) {
            // certainly on the wall, within the hit's error
            boolean touches = Math.abs(power) + POWER_ERROR * squaredDistance
                <= 2 * shaft.pointError * Math.sqrt(squaredDistance);
            double error = (r + slack) * (ShadowShaft.ROUNDING * shaft.cornerDistance + 4 * shaft.margin)
                + slack * shaft.cornerDistance;
            int sideOfHit = touches ? shaft.sideOf(surface) : UNKNOWN;
            add(surface, i, mx, my, mz * shaft.depth, power,
                sideOfHit > 0 && shaft.usesOwnCoordinates ? error : ALWAYS_IN_DOUBT, sideOfHit);
        }
    }

    /** For a sphere between point and square: whether it is met on the way to all four corners, and so on all ways. */
    private static boolean hidesSquare(ShadowShaft shaft, double mx, double my, double mz, double squaredDistance,
                                       double shrunk) {
        double least = mz * shaft.depth - shaft.halfWidth * (Math.abs(mx) + Math.abs(my));
        double squaredCorner = shaft.cornerDistance * shaft.cornerDistance;
        double limit = (squaredDistance - shrunk * shrunk + ShadowShaft.ROUNDING * squaredDistance) * squaredCorner;
        return shrunk > 0 && least > 0 && least * least > limit;
    }

    /** Whether the point is inside and the square outside, or the other way round. */
    private static boolean separatesSquare(ShadowShaft shaft, double mx, double my, double mz, double squaredDistance,
                                           double grown, double shrunk) {
        if (shrunk <= 0) {
            return false;
        }
        double gap = shaft.depth - mz;
        double besideX = Math.max(Math.abs(mx) - shaft.halfWidth, 0);
        double besideY = Math.max(Math.abs(my) - shaft.halfWidth, 0);
        if (squaredDistance < shrunk * shrunk) {
            return besideX * besideX + besideY * besideY + gap * gap > grown * grown;
        }
        return squaredDistance > grown * grown && squaredFarthest(shaft, mx, my, gap) < shrunk * shrunk;
    }

    /** Whether both the point and the square are inside. */
    private static boolean isAround(ShadowShaft shaft, double mx, double my, double mz, double squaredDistance,
                                    double shrunk) {
        return shrunk > 0 && squaredDistance < shrunk * shrunk
            && squaredFarthest(shaft, mx, my, shaft.depth - mz) < shrunk * shrunk;
    }

    private static double squaredFarthest(ShadowShaft shaft, double mx, double my, double gap) {
        double farX = Math.abs(mx) + shaft.halfWidth;
        double farY = Math.abs(my) + shaft.halfWidth;
        return farX * farX + farY * farY + gap * gap;
    }

    private void add(int surface, int i, double mx, double my, double mzTimesDepth, double power, double error,
                     int sideOfHit) {
        if (count == entry.length) {
            grow();
        }
        entry[count] = i;
        number[count] = surface;
        across[count] = mx;
        up[count] = my;
        ahead[count] = mzTimesDepth;
        this.power[count] = power;
        doubt[count] = error;
        side[count] = sideOfHit;
        count++;
    }

    private void grow() {
        entry = Arrays.copyOf(entry, 2 * count);
        number = Arrays.copyOf(number, 2 * count);
        across = Arrays.copyOf(across, 2 * count);
        up = Arrays.copyOf(up, 2 * count);
        ahead = Arrays.copyOf(ahead, 2 * count);
        power = Arrays.copyOf(power, 2 * count);
        doubt = Arrays.copyOf(doubt, 2 * count);
        side = Arrays.copyOf(side, 2 * count);
    }

    /** Adds the shadows of these spheres on the shaft's square. */
    void addShadows(ShadowShaft shaft, SphereShadow shadow, double[] transmittanceOf, SceneOrder order) {
        order.sort(number, count);
        for (int k = 0; k < count; k++) {
            int i = order.place(k);
            shadow.add(shaft, number[i], across[i], up[i], ahead[i] / shaft.depth, spheres.radius(entry[i]),
                transmittanceOf[number[i]]);
        }
    }

    /** Adds the spheres that the shaft's line to (x, y) of the light square crosses. */
    void addCrossed(ShadowShaft shaft, double x, double y) {
        double squaredLength = x * x + y * y + shaft.depth * shaft.depth;
        for (int i = 0; i < count && !shaft.crossed.isDark(); i++) {
            double product = x * across[i] + y * up[i] + ahead[i];
            boolean isCrossed;
            if (side[i] == UNKNOWN) {
                double inside = product * product - power[i] * squaredLength;
                isCrossed = Math.abs(inside) > doubt[i] ? inside > 0 && product > 0 : spheres.isCrossed(shaft, entry[i]);
            } else if (side[i] > 0) {
                isCrossed = Math.abs(product) > doubt[i] ? product > 0 : spheres.isCrossed(shaft, entry[i]);
            } else {
                isCrossed = shaft.endsOutside(number[i]);
            }
            if (isCrossed) {
                shaft.crossed.add(number[i]);
            }
        }
    }
}
