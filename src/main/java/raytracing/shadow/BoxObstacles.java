package raytracing.shadow;

import raytracing.area.ConvexShadows;
import raytracing.math.Basis;
import raytracing.math.Slabs;
import raytracing.math.Vector;
import raytracing.surface.Box;
import raytracing.surface.Segment;
import raytracing.trace.CrossedSurfaces;
import raytracing.trace.PreparedScene;

/**
 * The boxes that some lines of a shaft cross and others may not.
 *
 * <p>Of a box that the hit touches, the side of the hit is found once: from inside, a line crosses the walls if it ends
 * outside; from before one of the faces, and not near their edges, if it goes in.
 *
 * <p>Lines bound the shadow of a box on the square. Every one is the trace of a plane: through the hit and an edge that the
 * hit sees as part of the box's outline, or of a wall that faces the hit.
 */
final class BoxObstacles extends Obstacles<BoxObstacles.BoxObstacle> {
    /** A box, and what is known of the start of the lines. */
    static final class BoxObstacle extends Obstacle {
        private Box box;

        /** The axis of the one face from before which the lines start, or {@link #FROM_INSIDE} or {@link #UNKNOWN}. */
        private int start;

        @Override
        void dim(double passing, Shaft shaft, LightSamples samples) {
            double[] transmittance = samples.transmittance;
            for (int i = 0; i < samples.count; i++) {
                if (transmittance[i] > 0 && isCrossed(shaft, shaft.segmentTo(samples.x[i], samples.y[i]))) {
                    transmittance[i] *= passing;
                }
            }
        }

        private boolean isCrossed(Shaft shaft, Segment line) {
            return switch (start) {
                case UNKNOWN -> box.isCrossed(line, number);
                case FROM_INSIDE -> box.isLeft(line);
                default -> isCrossedFromFace(shaft, line);
            };
        }

        /** For a line that starts before a face, on its plane as far as is known, and not near its edges. */
        private boolean isCrossedFromFace(Shaft shaft, Segment line) {
            Vector centre = box.centre();
            double inwards = switch (start) {
                case 0 -> Math.copySign(1, centre.x() - shaft.hit.x()) * line.dx();
                case 1 -> Math.copySign(1, centre.y() - shaft.hit.y()) * line.dy();
                default -> Math.copySign(1, centre.z() - shaft.hit.z()) * line.dz();
            };
            return Math.abs(inwards) > shaft.margin ? inwards > 0 : box.isCrossed(line, number);
        }
    }

    private static final int AXES = 3;

    /** Half a diagonal of a cube over its edge, rounded up. */
    private static final double HALF_DIAGONAL = 0.8660255;
    private static final int UNKNOWN = -1;
    private static final int FROM_INSIDE = 3;

    /** Above what two roundings take from the way to a face, in halves of the edge: 4 u, with u = 2^-53. */
    private static final double ROUNDING = 0x1p-51;

    private final Box[] boxes;

    /** Of the box whose shadow is found: the way from the hit to the centre along each axis, and to the wall that faces it. */
    private final double[] toCentre = new double[AXES];
    private final double[] toWall = new double[AXES];
    private final boolean[] isFacing = new boolean[AXES];
    private double halfEdge;

    BoxObstacles(Shaft shaft, PreparedScene scene) {
        super(shaft, scene, scene.boxes(), new BoxObstacle[0]);
        boxes = scene.boxes().boxes();
    }

    @Override
    BoxObstacle create() {
        return new BoxObstacle();
    }

    @Override
    boolean isBeside(int place, NearbyShafts shafts) {
        Box box = boxes[place];
        return shafts.isBeside(box.centre().x(), box.centre().y(), box.centre().z(), HALF_DIAGONAL * box.edge());
    }

    @Override
    void sort(int[] numbers, int from, int to, CrossedSurfaces certain) {
        int surfaceLeft = shaft.hit.surface();
        for (int i = from; i < to && !certain.isDark(); i++) {
            if (numbers[i] != surfaceLeft) {
                sort(boxes[i], numbers[i], certain);
            }
        }
    }

    private void sort(Box box, int number, CrossedSurfaces certain) {
        double fx = box.centre().x() - shaft.hit.x();
        double fy = box.centre().y() - shaft.hit.y();
        double fz = box.centre().z() - shaft.hit.z();
        double half = box.edge() / 2;
        double slack = shaft.slack(fx, fy, fz, half);
        double grown = half + slack;
        if (shaft.isBeside(fx, fy, fz, grown)) {
            return;
        }
        double shrunk = half - slack;
        double farthest = Vector.largestPart(fx, fy, fz);
        if (farthest < shrunk) {
            double gx = Math.abs(fx - shaft.tx);
            double gy = Math.abs(fy - shaft.ty);
            double gz = Math.abs(fz - shaft.tz);
            if (greatest(gx + shaft.extentX, gy + shaft.extentY, gz + shaft.extentZ) < shrunk) {
                return;                      // around hit and square
            }
            if (greatest(gx - shaft.extentX, gy - shaft.extentY, gz - shaft.extentZ) > grown) {
                certain.add(number);         // around the hit, and the square is outside
                return;
            }
        } else if (farthest > grown && hidesSquare(fx, fy, fz, shrunk)) {
            certain.add(number);
            return;
        }
        BoxObstacle obstacle = add(number);
        obstacle.box = box;
        obstacle.start = Math.abs(farthest - half) <= slack
            ? start(box.side(shaft.hit.origin(), number), fx, fy, fz, half) : UNKNOWN;
    }

    /** What is known of a start that may be on the walls. */
    private int start(int side, double fx, double fy, double fz, double half) {
        if (side <= 0) {
            return side < 0 ? FROM_INSIDE : UNKNOWN;
        }
        return isOnFace(fx, fy, fz, half) ? 0 : isOnFace(fy, fx, fz, half) ? 1 : isOnFace(fz, fx, fy, half) ? 2 : UNKNOWN;
    }

    /** Whether the start is certainly on a face's plane, within its error, and away from the edges of the face. */
    private boolean isOnFace(double away, double alongOne, double alongOther, double half) {
        double inside = half - shaft.margin;
        return Math.abs(Math.abs(away) - half) + ROUNDING * half <= shaft.hit.error()
            && Math.abs(alongOne) < inside && Math.abs(alongOther) < inside;
    }

    /** Whether the way to all four corners goes into the box: then all ways do, as a shadow of a box is convex. */
    private boolean hidesSquare(double fx, double fy, double fz, double shrunk) {
        double w = shaft.halfWidth;
        return shrunk > 0 && hidesCorner(w, w, fx, fy, fz, shrunk) && hidesCorner(w, -w, fx, fy, fz, shrunk)
            && hidesCorner(-w, w, fx, fy, fz, shrunk) && hidesCorner(-w, -w, fx, fy, fz, shrunk);
    }

    /** Whether the line to the corner (x, y) enters the box before its end, and not only at an edge. */
    private boolean hidesCorner(double x, double y, double fx, double fy, double fz, double half) {
        Basis axes = shaft.axes;
        double dx = shaft.tx + x * axes.ux() + y * axes.vx();
        double dy = shaft.ty + x * axes.uy() + y * axes.vy();
        double dz = shaft.tz + x * axes.uz() + y * axes.vz();
        double ix = 1 / Math.abs(dx);
        double iy = 1 / Math.abs(dy);
        double iz = 1 / Math.abs(dz);
        double mx = Slabs.ahead(0, dx, fx);
        double my = Slabs.ahead(0, dy, fy);
        double mz = Slabs.ahead(0, dz, fz);
        double entry = Slabs.entry(mx, my, mz, half, ix, iy, iz);
        double exit = Slabs.exit(mx, my, mz, half, ix, iy, iz);
        return entry > 0 && entry < Math.min(1, exit) - Shaft.ROUNDING * (1 + exit);
    }

    private static double greatest(double x, double y, double z) {
        return Math.max(x, Math.max(y, z));
    }

    private void lookAt(Box box) {
        halfEdge = box.edge() / 2;
        toCentre[0] = box.centre().x() - shaft.hit.x();
        toCentre[1] = box.centre().y() - shaft.hit.y();
        toCentre[2] = box.centre().z() - shaft.hit.z();
    }

    /** Of a hit very near to a wall, exact numbers tell the side. */
    @Override
    void addShadow(BoxObstacle obstacle, double passing, ConvexShadows shadows) {
        lookAt(obstacle.box);
        double slack = shaft.slack(toCentre[0], toCentre[1], toCentre[2], halfEdge);
        boolean isOutside = false;
        for (int i = 0; i < AXES; i++) {
            double distance = Math.abs(toCentre[i]) - halfEdge;
            boolean isClear = Math.abs(distance) > slack;
            double side = isClear ? distance : obstacle.box.side(shaft.hit.origin(), obstacle.number, i);
            isFacing[i] = side >= 0;
            toWall[i] = isClear ? distance : 0;
            isOutside |= side > 0;
        }
        if (isOutside) {
            addShadowFromOutside(passing, shadows);
        } else {
            addShadowFromWithin(passing, shadows);
        }
    }

    private void addShadowFromOutside(double passing, ConvexShadows shadows) {
        shadows.beginFigure(passing, 1);
        for (int i = 0; i < AXES; i++) {
            if (isFacing[i]) {
                addLine(i, 1, -toWall[i], shadows);
                addOutline(i, (i + 1) % AXES, shadows);
                addOutline(i, (i + 2) % AXES, shadows);
            }
        }
    }

    /** Everything behind the walls that the hit is on, but for what is in the box. */
    private void addShadowFromWithin(double passing, ConvexShadows shadows) {
        shadows.beginFigure(1, passing);
        for (int i = 0; i < AXES; i++) {
            if (isFacing[i]) {
                addLine(i, 1, 0, shadows);
            }
        }
        exceptInside(shadows);
    }

    /**
     * The outline's edges between a facing wall and the two walls across an axis, one near and one far. With all axes
     * turned so that the centre is ahead, the hit sees the edge at (toWall, reach).
     */
    private void addOutline(int wall, int across, ConvexShadows shadows) {
        double ahead = Math.abs(toCentre[across]);
        addLine(wall, ahead + halfEdge, across, -toWall[wall], shadows);
        if (!isFacing[across] && toWall[across] != 0) {
            addLine(wall, halfEdge - ahead, across, toWall[wall], shadows);
        }
    }

    /** Adds the shadow of the box that was hit: everything on the inner side of a line but what is in the box. */
    void addOwnShadow(Box box, double lineA, double lineB, double lineC, double passing, ConvexShadows shadows) {
        lookAt(box);
        shadows.beginFigure(1, passing);
        shadows.addLine(lineA, lineB, lineC);
        exceptInside(shadows);
    }

    private void exceptInside(ConvexShadows shadows) {
        shadows.beginOutline();
        for (int i = 0; i < AXES; i++) {
            addLine(i, 1, halfEdge - Math.abs(toCentre[i]), shadows);
            addLine(i, -1, halfEdge + Math.abs(toCentre[i]), shadows);
        }
    }

    /** factor e_i + constant &gt;= 0, the axis turned so that the centre is ahead. */
    private void addLine(int axis, double factor, double constant, ConvexShadows shadows) {
        double f = toCentre[axis] < 0 ? -factor : factor;
        shadows.addLine(f * alongU(axis), f * alongV(axis), f * toLight(axis) + constant);
    }

    /** first e_i + second e_j &gt;= 0, both axes turned so that the centre is ahead. */
    private void addLine(int i, double first, int j, double second, ConvexShadows shadows) {
        double f = toCentre[i] < 0 ? -first : first;
        double s = toCentre[j] < 0 ? -second : second;
        shadows.addLine(f * alongU(i) + s * alongU(j), f * alongV(i) + s * alongV(j), f * toLight(i) + s * toLight(j));
    }

    private double alongU(int axis) {
        return axis == 0 ? shaft.axes.ux() : axis == 1 ? shaft.axes.uy() : shaft.axes.uz();
    }

    private double alongV(int axis) {
        return axis == 0 ? shaft.axes.vx() : axis == 1 ? shaft.axes.vy() : shaft.axes.vz();
    }

    private double toLight(int axis) {
        return axis == 0 ? shaft.tx : axis == 1 ? shaft.ty : shaft.tz;
    }
}
