package raytracing.shadow;

import raytracing.area.ConvexShadows;
import raytracing.math.Basis;
import raytracing.math.Determinant;
import raytracing.math.Vector;
import raytracing.surface.Hit;
import raytracing.surface.Triangle;
import raytracing.trace.CrossedSurfaces;
import raytracing.trace.PreparedScene;

/**
 * The triangles that some lines of a shaft cross and others may not.
 *
 * <p>A line to a point of the square crosses a triangle if it passes all three edges on the inner side and ends beyond the
 * plane. How far it is on the inner side of an edge, and beyond the plane, as volumes, is linear in the square's coordinates:
 * so the least and the greatest are at corners, and the shadow of the triangle is bounded by the lines where they are 0.
 */
final class TriangleObstacles extends Obstacles<TriangleObstacles.TriangleObstacle> {
    /** A volume that is linear in the square's coordinates. */
    private static final class Volume {
        private double middle;
        private double alongU;
        private double alongV;

        private double at(double x, double y) {
            return middle + x * alongU + y * alongV;
        }

        /** By how much it differs at most from that of the middle, in a square of this half edge. */
        private double spread(double halfWidth) {
            return halfWidth * (Math.abs(alongU) + Math.abs(alongV));
        }

        /**
         * The volume of the ways from a point to the ends of an edge and to a point of the square.
         *
         * @param x way from the point to the middle of the square
         */
        private void set(double ax, double ay, double az, double bx, double by, double bz,
                         double x, double y, double z, Basis axes) {
            double nx = ay * bz - az * by;
            double ny = az * bx - ax * bz;
            double nz = ax * by - ay * bx;
            middle = nx * x + ny * y + nz * z;
            alongU = nx * axes.ux() + ny * axes.uy() + nz * axes.uz();
            alongV = nx * axes.vx() + ny * axes.vy() + nz * axes.vz();
        }

        private void set(double newMiddle, double newAlongU, double newAlongV) {
            middle = newMiddle;
            alongU = newAlongU;
            alongV = newAlongV;
        }
    }

    /** A triangle, seen from the hit; its volumes are above 0 on the inner side of an edge, and beyond the plane. */
    static final class TriangleObstacle extends Obstacle {
        private final Volume ab = new Volume();
        private final Volume bc = new Volume();
        private final Volume ca = new Volume();
        private final Volume beyond = new Volume();
        private Triangle triangle;

        /** 1 if the normal points away from the hit, -1 if to it; 0 if rounding leaves that open. */
        private int sign;

        /** How far the volumes of edges, and that of the plane, may be off. */
        private double doubt;
        private double doubtBeyond;

        @Override
        void dim(double passing, Shaft shaft, LightSamples samples) {
            double[] transmittance = samples.transmittance;
            for (int i = 0; i < samples.count; i++) {
                if (transmittance[i] > 0 && isCrossed(samples.x[i], samples.y[i], shaft)) {
                    transmittance[i] *= passing;
                }
            }
        }

        private boolean isCrossed(double x, double y, Shaft shaft) {
            double inside = Math.min(ab.at(x, y), Math.min(bc.at(x, y), ca.at(x, y)));
            double past = beyond.at(x, y);
            if (inside < -doubt || past < -doubtBeyond) {
                return false;
            }
            return inside > doubt && past > doubtBeyond || triangle.isCrossed(shaft.segmentTo(x, y), number);
        }
    }

    private final Triangle[] triangles;
    private final TriangleObstacle sorted = new TriangleObstacle();

    /** How far the gap of the triangle looked at last may be off. */
    private double gapError;

    TriangleObstacles(Shaft shaft, PreparedScene scene) {
        super(shaft, scene, scene.triangles(), new TriangleObstacle[0]);
        triangles = scene.triangles().triangles();
    }

    @Override
    TriangleObstacle create() {
        return new TriangleObstacle();
    }

    @Override
    boolean isBeside(int place, NearbyShafts shafts) {
        Triangle triangle = triangles[place];
        return shafts.isBeside(triangle.middleX(), triangle.middleY(), triangle.middleZ(), triangle.radius());
    }

    @Override
    void sort(int[] numbers, int from, int to, CrossedSurfaces certain) {
        int surfaceLeft = shaft.hit.surface();
        for (int i = from; i < to && !certain.isDark(); i++) {
            if (numbers[i] != surfaceLeft && !isBesideAxis(triangles[i])) {
                sort(triangles[i], numbers[i], certain);
            }
        }
    }

    /** Whether all corners are certainly beyond the same wall of the shaft. */
    private boolean isBesideAxis(Triangle triangle) {
        Hit hit = shaft.hit;
        Basis axes = shaft.axes;
        int besides = 0b111111;
        for (int i = 0; i < 3 && besides != 0; i++) {
            double x = triangle.x(i) - hit.x();
            double y = triangle.y(i) - hit.y();
            double z = triangle.z(i) - hit.z();
            // rounded is what is taken from the hit, and its rounding is at most that of the way and of the hit
            double slack = shaft.margin + Shaft.ROUNDING * (shaft.reach + Math.abs(x) + Math.abs(y) + Math.abs(z));
            double mx = x * axes.ux() + y * axes.uy() + z * axes.uz();
            double my = x * axes.vx() + y * axes.vy() + z * axes.vz();
            double mz = x * axes.wx() + y * axes.wy() + z * axes.wz();
            double wall = shaft.halfWidth * mz + slack * (shaft.slant + shaft.depth);
            besides &= (mx * shaft.depth > wall ? 1 : 0) | (-mx * shaft.depth > wall ? 2 : 0)
                | (my * shaft.depth > wall ? 4 : 0) | (-my * shaft.depth > wall ? 8 : 0)
                | (mz < -slack ? 16 : 0) | (mz > shaft.depth + slack ? 32 : 0);
        }
        return besides != 0;
    }

    private void sort(Triangle triangle, int number, CrossedSurfaces certain) {
        TriangleObstacle seen = sorted;
        double gap = look(triangle, seen);
        double half = shaft.halfWidth;
        double error = seen.doubt;
        if (!(Math.abs(gap) > gapError)) {
            if (!isPassedOnBothSides(seen, half)) {
                keep(triangle, number, 0);
            }
            return;
        }
        int sign = gap > 0 ? 1 : -1;
        double ab = sign * seen.ab.middle;
        double bc = sign * seen.bc.middle;
        double ca = sign * seen.ca.middle;
        double beyond = sign * seen.beyond.middle;
        double spreadAb = seen.ab.spread(half);
        double spreadBc = seen.bc.spread(half);
        double spreadCa = seen.ca.spread(half);
        double spreadBeyond = seen.beyond.spread(half);
        if (ab + spreadAb < -error || bc + spreadBc < -error || ca + spreadCa < -error
                || beyond + spreadBeyond < -seen.doubtBeyond) {
            return;
        }
        if (ab - spreadAb > error && bc - spreadBc > error && ca - spreadCa > error
                && beyond - spreadBeyond > seen.doubtBeyond) {
            certain.add(number);
        } else {
            keep(triangle, number, sign);
        }
    }

    /**
     * Works out the volumes of a triangle as its normal points; returns the gap between hit and plane, above 0 where the
     * normal points away from the hit.
     */
    private double look(Triangle triangle, TriangleObstacle seen) {
        Hit hit = shaft.hit;
        double ax = triangle.ax() - hit.x();
        double ay = triangle.ay() - hit.y();
        double az = triangle.az() - hit.z();
        double bx = triangle.bx() - hit.x();
        double by = triangle.by() - hit.y();
        double bz = triangle.bz() - hit.z();
        double cx = triangle.cx() - hit.x();
        double cy = triangle.cy() - hit.y();
        double cz = triangle.cz() - hit.z();
        seen.ab.set(ax, ay, az, bx, by, bz, shaft.tx, shaft.ty, shaft.tz, shaft.axes);
        seen.bc.set(bx, by, bz, cx, cy, cz, shaft.tx, shaft.ty, shaft.tz, shaft.axes);
        seen.ca.set(cx, cy, cz, ax, ay, az, shaft.tx, shaft.ty, shaft.tz, shaft.axes);
        double gap = Determinant.rounded(ax, ay, az, bx, by, bz, cx, cy, cz);
        seen.beyond.set(seen.ab.middle + seen.bc.middle + seen.ca.middle - gap,
            seen.ab.alongU + seen.bc.alongU + seen.ca.alongU, seen.ab.alongV + seen.bc.alongV + seen.ca.alongV);
        double m = Math.max(Vector.largestPart(ax, ay, az),
            Math.max(Vector.largestPart(bx, by, bz), Vector.largestPart(cx, cy, cz)));
        double end = 2 * (shaft.depth + 2 * shaft.halfWidth);      // above the sum of the sizes of a line's coordinates
        seen.doubt = m * ((Shaft.ROUNDING * m + 8 * shaft.margin) * end + 8 * m * shaft.margin);
        gapError = m * m * (3 * Shaft.ROUNDING * m + 96 * shaft.margin);
        seen.doubtBeyond = 3 * seen.doubt + gapError;
        return gap;
    }

    /** Whether two edges are certainly passed on opposite sides by all lines. */
    private static boolean isPassedOnBothSides(TriangleObstacle seen, double half) {
        return isClear(seen.ab, 1, seen, half) | isClear(seen.bc, 1, seen, half) | isClear(seen.ca, 1, seen, half)
            && isClear(seen.ab, -1, seen, half) | isClear(seen.bc, -1, seen, half) | isClear(seen.ca, -1, seen, half);
    }

    private static boolean isClear(Volume volume, int sign, TriangleObstacle seen, double half) {
        return sign * volume.middle - volume.spread(half) > seen.doubt;
    }

    /** Adds the triangle looked at as an obstacle, its volumes turned towards the lines that cross it. */
    private void keep(Triangle triangle, int number, int sign) {
        TriangleObstacle obstacle = add(number);
        obstacle.triangle = triangle;
        obstacle.sign = sign;
        turn(sorted.ab, sign, obstacle.ab);
        turn(sorted.bc, sign, obstacle.bc);
        turn(sorted.ca, sign, obstacle.ca);
        turn(sorted.beyond, sign, obstacle.beyond);
        obstacle.doubt = sign != 0 ? doubt(sorted.doubt) : ALWAYS_IN_DOUBT;
        obstacle.doubtBeyond = sign != 0 ? doubt(sorted.doubtBeyond) : ALWAYS_IN_DOUBT;
    }

    private static void turn(Volume from, int sign, Volume to) {
        to.set(sign * from.middle, sign * from.alongU, sign * from.alongV);
    }

    /** Of a hit very near to the plane, exact numbers tell the side, and which edges it is on. */
    @Override
    void addShadow(TriangleObstacle obstacle, double passing, ConvexShadows shadows) {
        if (obstacle.sign != 0) {
            shadows.beginFigure(passing, 1);
            addLine(obstacle.beyond, 1, shadows);
            addEdges(obstacle, 1, shadows);
            return;
        }
        int sign = -obstacle.triangle.side(shaft.hit.origin(), obstacle.number);
        if (sign != 0) {
            int touched = obstacle.triangle.touchedEdges(shaft.hit.origin());
            look(obstacle.triangle, sorted);
            shadows.beginFigure(passing, 1);
            addLine(sorted.beyond, sign, shadows);
            if (touched == Triangle.NOT_TOUCHED) {
                addEdges(sorted, sign, shadows);
            } else {
                addTouchedEdges(obstacle.triangle, touched, sign, shadows);
            }
        }
    }

    private static void addEdges(TriangleObstacle seen, int turn, ConvexShadows shadows) {
        addLine(seen.ab, turn, shadows);
        addLine(seen.bc, turn, shadows);
        addLine(seen.ca, turn, shadows);
    }

    /** Of an edge that the hit is on, the line as seen from where the hit was seen; others are passed on the inner side. */
    private void addTouchedEdges(Triangle triangle, int touched, int sign, ConvexShadows shadows) {
        Vector eye = shaft.hit.origin().seenFrom();
        addEdge(touched & Triangle.AB, triangle.a().minus(eye), triangle.b().minus(eye), eye, sign, shadows);
        addEdge(touched & Triangle.BC, triangle.b().minus(eye), triangle.c().minus(eye), eye, sign, shadows);
        addEdge(touched & Triangle.CA, triangle.c().minus(eye), triangle.a().minus(eye), eye, sign, shadows);
    }

    private void addEdge(int touched, Vector from, Vector to, Vector eye, int sign, ConvexShadows shadows) {
        if (touched != 0) {
            Volume volume = sorted.ab;
            volume.set(from.x(), from.y(), from.z(), to.x(), to.y(), to.z(),
                shaft.lx - eye.x(), shaft.ly - eye.y(), shaft.lz - eye.z(), shaft.axes);
            addLine(volume, sign, shadows);
        }
    }

    private static void addLine(Volume volume, int turn, ConvexShadows shadows) {
        shadows.addLine(turn * volume.alongU, turn * volume.alongV, turn * volume.middle);
    }
}
