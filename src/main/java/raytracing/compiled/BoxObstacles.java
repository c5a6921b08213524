package raytracing.compiled;

import java.util.Arrays;

/** The boxes that some lines of a shaft cross and others may not. One thread, shaft after shaft. */
final class BoxObstacles {
    private final BoxArray boxes;
    private int[] entry = new int[8];
    private int[] number = new int[8];
    private int count;

    BoxObstacles(BoxArray boxes) {
        this.boxes = boxes;
    }

    void clear() {
        count = 0;
    }

    int count() {
        return count;
    }

    /**
     * Finds out what a box is to a shaft.
     *
     * @param fx way from the shaded point to the box's centre, world axes, x part
     * @param fy y part
     * @param fz z part
     * @param half half its edge
     */
    void consider(ShadowShaft shaft, int surface, int i, double fx, double fy, double fz, double half) {
        double size = Math.abs(fx) + Math.abs(fy) + Math.abs(fz);
        double slack = shaft.margin + ShadowShaft.ROUNDING * (size + half);
        double grown = half + slack;
        if (shaft.isBeside(fx, fy, fz, grown, grown, grown)) {
            return;
        }
        double shrunk = half - slack;
        double farthest = greatest(Math.abs(fx), Math.abs(fy), Math.abs(fz));
        if (farthest < shrunk) {
            double gx = Math.abs(fx - shaft.tx);
            double gy = Math.abs(fy - shaft.ty);
            double gz = Math.abs(fz - shaft.tz);
            if (greatest(gx + shaft.extentX, gy + shaft.extentY, gz + shaft.extentZ) < shrunk) {
                return;                      // around point and square
            }
            if (greatest(gx - shaft.extentX, gy - shaft.extentY, gz - shaft.extentZ) > grown) {
                shaft.certain.add(surface);  // around the point, and the square is outside
                return;
            }
        } else if (farthest > grown && hidesSquare(shaft, fx, fy, fz, shrunk)) {
            shaft.certain.add(surface);
            return;
        }
        if (count == entry.length) {
            entry = Arrays.copyOf(entry, 2 * count);
            number = Arrays.copyOf(number, 2 * count);
        }
        entry[count] = i;
        number[count] = surface;
        count++;
    }

    /** Whether the way to all four corners goes into the box: then all ways do, as a shadow of a box is convex. */
    private static boolean hidesSquare(ShadowShaft shaft, double fx, double fy, double fz, double shrunk) {
        double ux = shaft.halfWidth * shaft.ux;
        double uy = shaft.halfWidth * shaft.uy;
        double uz = shaft.halfWidth * shaft.uz;
        double vx = shaft.halfWidth * shaft.vx;
        double vy = shaft.halfWidth * shaft.vy;
        double vz = shaft.halfWidth * shaft.vz;
        double tx = shaft.tx;
        double ty = shaft.ty;
        double tz = shaft.tz;
        return shrunk > 0
            && hidesCorner(tx + ux + vx, ty + uy + vy, tz + uz + vz, fx, fy, fz, shrunk)
            && hidesCorner(tx + ux - vx, ty + uy - vy, tz + uz - vz, fx, fy, fz, shrunk)
            && hidesCorner(tx - ux + vx, ty - uy + vy, tz - uz + vz, fx, fy, fz, shrunk)
            && hidesCorner(tx - ux - vx, ty - uy - vy, tz - uz - vz, fx, fy, fz, shrunk);
    }

    /** Whether the line from 0 to (dx, dy, dz) enters the box around f before its end, and not only at an edge. */
    private static boolean hidesCorner(double dx, double dy, double dz, double fx, double fy, double fz, double h) {
        double ix = 1 / Math.abs(dx);
        double iy = 1 / Math.abs(dy);
        double iz = 1 / Math.abs(dz);
        double mx = Math.copySign(1, dx) * fx;
        double my = Math.copySign(1, dy) * fy;
        double mz = Math.copySign(1, dz) * fz;
        double entry = greatest((mx - h) * ix, (my - h) * iy, (mz - h) * iz);
        double exit = Math.min((mx + h) * ix, Math.min((my + h) * iy, (mz + h) * iz));
        return entry > 0 && entry < Math.min(1, exit) - ShadowShaft.ROUNDING * (1 + exit);
    }

    private static double greatest(double x, double y, double z) {
        return Math.max(x, Math.max(y, z));
    }

    /** Adds the shadows of these boxes on the shaft's square. */
    void addShadows(ShadowShaft shaft, BoxShadow shadow, double[] transmittanceOf, SceneOrder order) {
        order.sort(number, count);
        for (int k = 0; k < count; k++) {
            int i = order.place(k);
            boxes.addShadow(shaft, entry[i], shadow, transmittanceOf[number[i]]);
        }
    }

    /** Adds the boxes that the shaft's present line crosses. */
    void addCrossed(ShadowShaft shaft) {
        for (int i = 0; i < count && !shaft.crossed.isDark(); i++) {
            if (boxes.isCrossed(shaft, entry[i])) {
                shaft.crossed.add(number[i]);
            }
        }
    }
}
