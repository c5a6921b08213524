package raytracing.compiled;

import raytracing.geometry.Answer;
import raytracing.geometry.Box;
import raytracing.geometry.Departure;
import raytracing.geometry.HitPoint;
import raytracing.geometry.Surface;
import raytracing.math.Basis;
import raytracing.math.CounterRandom;
import raytracing.math.Vector;

/**
 * All lines along which light may come to a hit from a square that faces it: a pyramid, the shaft (Haines, Wallace, Shaft
 * Culling for Efficient Ray-Cast Radiosity, Eurographics Rendering Workshop 1991). When it is aimed, every surface turns out to
 * be beside it, which is forgotten; or to be crossed by all its lines, which is counted once; or to be an obstacle, which the
 * lines ask one by one. All answers are those of {@link ShadowLine}, bit for bit: whatever rounding leaves open makes an
 * obstacle.
 *
 * <p>The shaft's coordinates: x and y along the square's axes, z towards its middle, the hit at 0.
 *
 * <p>One thread, shaft after shaft.
 */
public final class ShadowShaft {
    /**
     * 256 u, with u = 2^-53: what the shaft's coordinates of a point may be off, and tests made of them, in multiples of the
     * sizes that went into them (proved: 8 ulp for the axes, at most 16 roundings in all).
     */
    static final double ROUNDING = 0x1p-45;

    /** Far below the rounding of the largest double: added to any double, it gives a double. */
    private static final double NOTHING_BESIDE_THE_LARGEST = 0x1p900;

    /** What a shaft is asked for. */
    public enum Use {
        /** Single lines: where there are more obstacles than this, they are asked one by one what they cross. */
        LINES(64),

        /** The shadows of all obstacles, so these are always sorted; of so many at most. */
        AREAS(128);

        private final int mostObstacles;

        Use(int mostObstacles) {
            this.mostObstacles = mostObstacles;
        }
    }

    /** The hit, and how far each part of it may be off. */
    double px;
    double py;
    double pz;
    double pointError;

    /** The middle of the light's square, and how far each part of it may be off. */
    double lx;
    double ly;
    double lz;
    double endError;

    /** The way from the hit to the middle of the square. */
    double tx;
    double ty;
    double tz;

    /** The shaft's axes: u and v along the square, n towards it. */
    double ux;
    double uy;
    double uz;
    double vx;
    double vy;
    double vz;
    double nx;
    double ny;
    double nz;
    double depth;
    double halfWidth;

    /** How far surfaces may be off, seen from the shaft: the errors of its ends eight times over, and its own rounding. */
    double margin;

    /** Sum of the sizes of all coordinates, which bounds the rounding of products with them. */
    double reach;

    /** From the hit to the middle of an edge of the square, and to a corner. */
    double slant;
    double cornerDistance;

    /** How far the square reaches from its middle along the world's axes. */
    double extentX;
    double extentY;
    double extentZ;
    int surfaceLeft;

    final boolean usesOwnCoordinates;
    final CrossedSurfaces certain;
    final CrossedSurfaces crossed;
    final SphereObstacles spheres;
    final PlaneObstacles planes;
    final BoxObstacles boxes;

    private final CompiledScene scene;
    private final Use use;
    private final ShadowLine line;
    private final PyramidWalk pyramidWalk = new PyramidWalk();
    private final Basis square = new Basis();
    private HitPoint hit;
    private boolean asksLines;

    /** Among many surfaces, the shaft next to a dark one is mostly dark too, which lines find out sooner. */
    private boolean wasDark;
    private double settledTransmittance;
    private boolean ownBodyIsObstacle;
    private double sampleX;
    private double sampleY;

    /**
     * A shaft that is not aimed.
     *
     * @param scene the surfaces
     * @param use what it will be asked for
     */
    public ShadowShaft(CompiledScene scene, Use use) {
        this.scene = scene;
        this.use = use;
        line = new ShadowLine(scene);
        certain = new CrossedSurfaces(scene.transmittances());
        crossed = new CrossedSurfaces(scene.transmittances());
        spheres = new SphereObstacles(scene.spheres());
        planes = new PlaneObstacles(scene.planes());
        boxes = new BoxObstacles(scene.boxes());
        usesOwnCoordinates = scene.uses(Shortcut.SHAFT_COORDINATES);
    }

    /** Forgets whether the last shaft was dark, which decides how the next answer is found, and never the answer. */
    public void forgetLast() {
        wasDark = false;
    }

    /**
     * Turns the shaft from a hit to a light and sorts the surfaces. One long method on purpose: the virtual machine does not
     * compile a method of more than 325 bytes into its callers again (DECISIONS).
     *
     * @param from the hit, which must stay as it is while the shaft is asked
     * @param lightX middle of the light's square, x part; not at the hit
     * @param lightY y part
     * @param lightZ z part
     * @param error how far each part of it may be off
     * @param width edge of the square; of a square that reaches beyond all doubles, a smaller one with the same middle is
     *        taken
     */
    public void aim(HitPoint from, double lightX, double lightY, double lightZ, double error, double width) {
        hit = from;
        surfaceLeft = hit.surface();
        px = hit.x();
        py = hit.y();
        pz = hit.z();
        pointError = hit.error();
        lx = lightX;
        ly = lightY;
        lz = lightZ;
        endError = error;
        double room = (Double.MAX_VALUE - Vector.largestPart(lx, ly, lz)) / 2;   // a corner is at most 1.5 half widths off
        halfWidth = Math.min(width / 2, Math.max(room, NOTHING_BESIDE_THE_LARGEST));
        tx = lx - px;
        ty = ly - py;
        tz = lz - pz;
        square.turnTo(tx, ty, tz);
        ux = square.ux();
        uy = square.uy();
        uz = square.uz();
        vx = square.vx();
        vy = square.vy();
        vz = square.vz();
        nx = square.wx();
        ny = square.wy();
        nz = square.wz();
        depth = tx * nx + ty * ny + tz * nz;
        reach = Math.abs(px) + Math.abs(py) + Math.abs(pz) + Math.abs(lx) + Math.abs(ly) + Math.abs(lz) + width;
        margin = 8 * (pointError + endError) + ROUNDING * (depth + halfWidth);
        slant = Math.sqrt(depth * depth + halfWidth * halfWidth);
        cornerDistance = Math.sqrt(depth * depth + 2 * halfWidth * halfWidth);
        extentX = halfWidth * (Math.abs(ux) + Math.abs(vx));
        extentY = halfWidth * (Math.abs(uy) + Math.abs(vy));
        extentZ = halfWidth * (Math.abs(uz) + Math.abs(vz));
        sort();
    }

    private void sort() {
        certain.clear();
        sortOwnBody();
        spheres.clear();
        planes.clear();
        boxes.clear();
        asksLines = use == Use.LINES && (!scene.uses(Shortcut.SHADOW_SHAFTS) || wasDark && scene.hasHierarchy());
        if (!asksLines) {
            scene.addTouched(this, pyramidWalk);
            wasDark = certain.isDark();
            asksLines = !wasDark && !isWorthSorting();
        }
        settledTransmittance = certain.transmittance();
    }

    /**
     * The surface of the hit. Where the whole square is above the horizon, all lines leave a body that is seen from
     * outside. All go through one that is seen from inside and far from the light.
     */
    private void sortOwnBody() {
        double height = hit.alongNormal(tx, ty, tz);
        double spread = halfWidth * (Math.abs(hit.alongNormal(ux, uy, uz)) + Math.abs(hit.alongNormal(vx, vy, vz)));
        boolean isWhollySeen = height - spread > margin;
        boolean isSeenFromInside = hit.side() == Departure.INWARD;
        ownBodyIsObstacle = !scene.isPlane(surfaceLeft) && !(isWhollySeen && !isSeenFromInside);
        if (ownBodyIsObstacle && isSeenFromInside
                && scene.surface(surfaceLeft).isApartFrom(lx, ly, lz, 2 * halfWidth + margin)) {
            ownBodyIsObstacle = false;
            certain.add(surfaceLeft);
        }
    }

    /** Whether surfaces should still be sorted: there is light left, and not so many obstacles that lines are as good. */
    boolean isWorthSorting() {
        return !certain.isDark() && spheres.count() + boxes.count() <= use.mostObstacles;
    }

    /** Whether a box of these half extents, margin included, with its centre (fx, fy, fz) from the hit is beside the shaft. */
    boolean isBeside(double fx, double fy, double fz, double halfX, double halfY, double halfZ) {
        if (fx - halfX > Math.max(0, tx + extentX) || fx + halfX < Math.min(0, tx - extentX)
                || fy - halfY > Math.max(0, ty + extentY) || fy + halfY < Math.min(0, ty - extentY)
                || fz - halfZ > Math.max(0, tz + extentZ) || fz + halfZ < Math.min(0, tz - extentZ)) {
            return true;
        }
        double mz = fx * nx + fy * ny + fz * nz;
        double halfDepth = halfX * Math.abs(nx) + halfY * Math.abs(ny) + halfZ * Math.abs(nz);
        if (mz + halfDepth < 0 || mz - halfDepth > depth) {
            return true;
        }
        return isBesideWall(fx, fy, fz, halfX, halfY, halfZ, ux, uy, uz)
            || isBesideWall(fx, fy, fz, halfX, halfY, halfZ, vx, vy, vz);
    }

    /** Whether a box is beyond one of the two walls whose normals are depth a - halfWidth n and -depth a - halfWidth n. */
    private boolean isBesideWall(double fx, double fy, double fz, double halfX, double halfY, double halfZ,
                                 double ax, double ay, double az) {
        double aside = depth * (fx * ax + fy * ay + fz * az);
        double inside = halfWidth * (fx * nx + fy * ny + fz * nz);
        return aside - inside > halfX * Math.abs(depth * ax - halfWidth * nx)
            + halfY * Math.abs(depth * ay - halfWidth * ny) + halfZ * Math.abs(depth * az - halfWidth * nz)
            || -aside - inside > halfX * Math.abs(depth * ax + halfWidth * nx)
            + halfY * Math.abs(depth * ay + halfWidth * ny) + halfZ * Math.abs(depth * az + halfWidth * nz);
    }

    /**
     * Whether all lines of the shaft cross the same surfaces, or all of them an opaque one.
     *
     * @return true if {@link #settledTransmittance} is that of every line
     */
    public boolean isSettled() {
        return certain.isDark()
            || !asksLines && !ownBodyIsObstacle && spheres.count() + planes.count() + boxes.count() == 0;
    }

    /**
     * How much light comes through along any line of a settled shaft.
     *
     * @return product of the crossed surfaces' transmittances, in [0, 1]
     */
    public double settledTransmittance() {
        return settledTransmittance;
    }

    /**
     * Whether the light is so narrow or so far away that rounding moves it by more than its width.
     *
     * @return true if only a line to its middle makes sense
     */
    public boolean isNarrowerThanRounding() {
        return halfWidth < ROUNDING * depth;
    }

    /**
     * Whether all obstacles are known. There may be too many for that.
     *
     * @return false if only lines can be asked
     */
    public boolean isSorted() {
        return !asksLines;
    }

    HitPoint hit() {
        return hit;
    }

    /** Whether the body that was hit hides some of the square. */
    boolean ownBodyIsObstacle() {
        return ownBodyIsObstacle;
    }

    /**
     * Sums how much light comes through along one line to each cell of the square, divided in root x root cells. Each line
     * goes to a random point of its cell.
     *
     * @param root number of cells along an edge, at least 1
     * @param key of the random numbers
     * @return sum of the transmittances of root x root lines, each in [0, 1]
     */
    public double sumOverCells(int root, long key) {
        double cell = 2 * halfWidth / root;
        double halfRoot = root / 2.0;
        double sum = 0;
        for (int row = 0; row < root; row++) {
            for (int column = 0; column < root; column++) {
                long bits = CounterRandom.bits(key, (long) row * root + column);
                double x = (column + CounterRandom.upperFraction(bits) - halfRoot) * cell;
                double y = (row + CounterRandom.lowerFraction(bits) - halfRoot) * cell;
                sum += transmittance(x, y);
            }
        }
        wasDark = sum == 0;
        return sum;
    }

    /**
     * How much light comes through along one line.
     *
     * @param x where it ends on the square, along its first axis, from the middle; in scene units
     * @param y the same along the second axis
     * @return product of the crossed surfaces' transmittances, in [0, 1]
     */
    double transmittance(double x, double y) {
        sampleX = x;
        sampleY = y;
        if (asksLines) {
            return line.transmittance(hit, endX(), endY(), endZ(), endError);
        }
        crossed.clear();
        if (spheres.count() > 0) {
            spheres.addCrossed(this, x, y);
        }
        if (planes.count() > 0) {
            planes.addCrossed(this, x, y);
        }
        if (boxes.count() > 0) {
            boxes.addCrossed(this);
        }
        if (ownBodyIsObstacle && !crossed.isDark()
                && scene.isOwnBodyCrossed(hit, endX(), endY(), endZ(), endError)) {
            crossed.add(surfaceLeft);
        }
        if (crossed.isEmpty()) {
            return settledTransmittance;
        }
        if (!crossed.isDark()) {
            crossed.addAll(certain);
        }
        return crossed.transmittance();
    }

    /** Whether the present line crosses a surface, given what doubles say. */
    boolean isCrossing(Answer quick, int surface) {
        return scene.isCrossed(quick, hit, surface, endX(), endY(), endZ(), endError);
    }

    /** Whether the present line ends outside a body. */
    boolean endsOutside(int surface) {
        return scene.surface(surface).isLeftBefore(endX(), endY(), endZ(), endError);
    }

    /** On which side of a surface the hit lies, as {@link Surface#side} says. */
    int sideOf(int surface) {
        return scene.surface(surface).side(hit.place(), surface);
    }

    /** On which side of the two faces of a box across an axis the hit lies, as {@link Box#side} says. */
    int sideOf(int box, int axis) {
        return scene.box(box).side(hit.place(), box, axis);
    }

    /** The end of the present line, world axes, x part. */
    double endX() {
        return lx + (sampleX * ux + sampleY * vx);
    }

    /** Its y part. */
    double endY() {
        return ly + (sampleX * uy + sampleY * vy);
    }

    /** Its z part. */
    double endZ() {
        return lz + (sampleX * uz + sampleY * vz);
    }
}
