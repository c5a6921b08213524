package raytracing.shadow;

import java.util.Arrays;
import raytracing.hierarchy.PyramidTraversal;
import raytracing.math.Basis;
import raytracing.math.CounterRandom;
import raytracing.surface.Body;
import raytracing.surface.Departure;
import raytracing.surface.Hit;
import raytracing.surface.Surface;
import raytracing.trace.CrossedSurfaces;
import raytracing.trace.PreparedScene;
import raytracing.trace.SegmentQuery;
import raytracing.trace.Shortcut;

/**
 * How much light comes through between a hit and the points of a light's square. When the shaft between them is aimed, every
 * surface turns out to be beside it, which is forgotten; or to be crossed by all its lines, which is counted once; or to be an
 * obstacle, which is tested for each line. All answers are those of {@link SegmentQuery}, bit for bit: whatever rounding
 * leaves open makes an obstacle. Used for shaft after shaft, so that shafts allocate nothing. Not thread-safe.
 */
final class ShaftQuery {
    /** What a shaft is for. */
    enum Use {
        /** Single lines: where there are more obstacles than this, each line is tested against the scene. */
        LINES(64),

        /** The shadows of all obstacles, so these are always sorted; of so many at most. */
        AREAS(128);

        private final int mostObstacles;

        Use(int mostObstacles) {
            this.mostObstacles = mostObstacles;
        }
    }

    final Shaft shaft = new Shaft();
    final SphereObstacles spheres;
    final PlaneObstacles planes;
    final BoxObstacles boxes;
    private final PreparedScene scene;
    private final Use use;
    private final boolean usesShafts;
    private final CrossedSurfaces certain;
    private final CrossedSurfaces crossed;
    private final SegmentQuery segmentQuery;
    private final PyramidTraversal traversal = new PyramidTraversal();

    private boolean isSorted;
    private boolean ownBodyIsObstacle;
    private double settledTransmittance;

    /** For each light: among many surfaces, the shaft next to a dark one is mostly dark too, which lines find out sooner. */
    private final boolean[] wasDark;

    /** Number of the light that the shaft leads to. */
    private int light;

    /** A shaft that is not aimed, for so many lights. */
    ShaftQuery(PreparedScene scene, Use use, int lightCount) {
        this.scene = scene;
        this.use = use;
        usesShafts = scene.uses(Shortcut.SHADOW_SHAFTS);
        spheres = new SphereObstacles(shaft, scene);
        planes = new PlaneObstacles(shaft, scene);
        boxes = new BoxObstacles(shaft, scene);
        certain = new CrossedSurfaces(scene.transmittances());
        crossed = new CrossedSurfaces(scene.transmittances());
        segmentQuery = new SegmentQuery(scene, lightCount);
        wasDark = new boolean[lightCount];
    }

    /** Forgets whether shafts were dark, which decides how the next answer is found, and never the answer. */
    void forgetPast() {
        Arrays.fill(wasDark, false);
    }

    /**
     * Turns the shaft from a hit to a light and sorts the surfaces. Long on purpose: the virtual machine does not compile a
     * method of more than 325 bytes into its callers again (DECISIONS).
     *
     * <p>Of the surface of the hit: where the whole square is above the horizon, all lines leave a body that is seen from
     * outside. All cross one that is seen from inside and far from the light. Other arguments are those of {@link Shaft#aim}.
     *
     * @param number of the light, from 0
     */
    void aim(Hit hit, int number, double lightX, double lightY, double lightZ, double error, double width) {
        light = number;
        shaft.aim(hit, lightX, lightY, lightZ, error, width);
        certain.clear();
        Surface own = scene.surface(hit.surface());
        Basis axes = shaft.axes;
        double height = hit.alongNormal(shaft.tx, shaft.ty, shaft.tz);
        double spread = shaft.halfWidth * (Math.abs(hit.alongNormal(axes.ux(), axes.uy(), axes.uz()))
            + Math.abs(hit.alongNormal(axes.vx(), axes.vy(), axes.vz())));
        boolean isWhollySeen = height - spread > shaft.margin;
        boolean isSeenFromInside = hit.side() == Departure.INWARD;
        ownBodyIsObstacle = own instanceof Body && !(isWhollySeen && !isSeenFromInside);
        if (isSeenFromInside && own instanceof Body body && shaft.endsApartFrom(body)) {
            ownBodyIsObstacle = false;
            certain.add(hit.surface());
        }
        isSorted = use == Use.AREAS || usesShafts && !(wasDark[light] && scene.hasHierarchy());
        if (isSorted) {
            planes.sort(use.mostObstacles, traversal, certain);
            spheres.sort(use.mostObstacles, traversal, certain);
            boxes.sort(use.mostObstacles - spheres.count, traversal, certain);
            wasDark[light] = certain.isDark();
            isSorted = certain.isDark() || spheres.count + boxes.count <= use.mostObstacles;
        }
        settledTransmittance = certain.transmittance();
    }

    /** Whether rounding moves the light by more than its width, so that only a line to its middle makes sense. */
    boolean isNarrowerThanRounding() {
        return shaft.isNarrowerThanRounding();
    }

    /** Whether all lines cross the same surfaces, or all of them an opaque one. */
    boolean isSettled() {
        return certain.isDark()
            || isSorted && !ownBodyIsObstacle && spheres.count + planes.count + boxes.count == 0;
    }

    /** What comes through along any line of a settled shaft, in [0, 1]. */
    double settledTransmittance() {
        return settledTransmittance;
    }

    /** Whether all obstacles are known; there may be too many for that. */
    boolean isSorted() {
        return isSorted;
    }

    /**
     * Sums how much light comes through along one line to each cell of the square, divided in root x root cells. Each line
     * goes to a random point of its cell.
     *
     * @param root number of cells along an edge, at least 1
     * @param key of the random numbers
     * @return sum of the transmittances of root x root lines, each in [0, 1]
     */
    double sumOverCells(int root, long key) {
        double cell = 2 * shaft.halfWidth / root;
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
        wasDark[light] = sum == 0;
        return sum;
    }

    /**
     * How much light comes through along the line to a point of the square.
     *
     * @param x along the square's first axis, from its middle, in scene units
     * @param y the same along the second axis
     * @return product of the crossed surfaces' transmittances, in [0, 1]
     */
    double transmittance(double x, double y) {
        if (!isSorted) {
            return segmentQuery.transmittance(shaft.hit, light, shaft.endX(x, y), shaft.endY(x, y), shaft.endZ(x, y),
                shaft.endError);
        }
        crossed.clear();
        if (spheres.count > 0) {
            spheres.addCrossed(x, y, crossed);
        }
        if (planes.count > 0) {
            planes.addCrossed(x, y, crossed);
        }
        if (boxes.count > 0) {
            boxes.addCrossed(x, y, crossed);
        }
        if (ownBodyIsObstacle && !crossed.isDark() && scene.isOwnBodyCrossed(shaft.hit, shaft.segmentTo(x, y))) {
            crossed.add(shaft.hit.surface());
        }
        if (crossed.isEmpty()) {
            return settledTransmittance;
        }
        if (!crossed.isDark()) {
            crossed.addAll(certain);
        }
        return crossed.transmittance();
    }

    /** Whether the body that was hit hides some of the square. */
    boolean ownBodyIsObstacle() {
        return ownBodyIsObstacle;
    }
}
