package raytracing.compiled;

import java.util.Arrays;

/**
 * The boxes that some lines of a shaft cross and others may not. One thread, shaft after shaft.
 *
 * <p>Of a box that the hit touches, the side of the hit is found once: from inside, a line crosses the walls if it ends outside;
 * from before one of the faces, and not near their edges, if it goes in.
 */
final class BoxObstacles {
    private static final int ASK = -1;
    private static final int FROM_INSIDE = 3;

    /** Above what two roundings take from the way to a face, in halves of the edge: 4 u, with u = 2^-53. */
    private static final double ROUNDING = 0x1p-51;

    private final BoxArray boxes;
    private int[] entry = new int[8];
    private int[] number = new int[8];

    /** The axis of the one face from before which the lines start, or {@link #FROM_INSIDE}, or nothing that is known. */
    private int[] start = new int[8];
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
            start = Arrays.copyOf(start, 2 * count);
        }
        entry[count] = i;
        number[count] = surface;
        start[count] = Math.abs(farthest - half) <= slack ? start(shaft, surface, fx, fy, fz, half) : ASK;
        count++;
    }

    /** What is known of a start that may be on the walls. */
    private static int start(ShadowShaft shaft, int surface, double fx, double fy, double fz, double half) {
        int side = shaft.sideOf(surface);
        if (side < 0) {
            return FROM_INSIDE;
        }
        double apart = shaft.margin;
        if (side > 0 && isOn(shaft, fx, half) && Math.abs(fy) < half - apart && Math.abs(fz) < half - apart) {
            return 0;
        }
        if (side > 0 && isOn(shaft, fy, half) && Math.abs(fx) < half - apart && Math.abs(fz) < half - apart) {
            return 1;
        }
        return side > 0 && isOn(shaft, fz, half) && Math.abs(fx) < half - apart && Math.abs(fy) < half - apart ? 2 : ASK;
    }

    /** Whether the start is certainly on a face's plane, within its error. */
    private static boolean isOn(ShadowShaft shaft, double toCentre, double half) {
        return Math.abs(Math.abs(toCentre) - half) + ROUNDING * half <= shaft.pointError;
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
            if (isCrossed(shaft, i)) {
                shaft.crossed.add(number[i]);
            }
        }
    }

    private boolean isCrossed(ShadowShaft shaft, int i) {
        return switch (start[i]) {
            case ASK -> boxes.isCrossed(shaft, entry[i]);
            case FROM_INSIDE -> shaft.endsOutside(number[i]);
            default -> boxes.isCrossedFromFace(shaft, entry[i], start[i]);
        };
    }
}
