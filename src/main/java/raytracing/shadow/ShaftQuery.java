package raytracing.shadow;

import java.util.Arrays;
import raytracing.hierarchy.PyramidTraversal;
import raytracing.math.Basis;
import raytracing.surface.Body;
import raytracing.surface.Bounded;
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

    /**
     * For so many pairs of a light and a surface, a power of 2, the shafts near the last one are remembered. Pairs that share a
     * place take it from each other, which only costs time.
     */
    private static final int NEARBY = 64;
    private static final int LIGHTS_APART = 13;

    /** The body that was hit, where some lines go through it from wall to wall. */
    private final class OwnBody extends Obstacles.Obstacle {
        /** How high the middle of the square is above the hit's horizon, and what each step along its axes adds. */
        private double height;
        private double alongU;
        private double alongV;

        /** How far heights may be off; infinite where the test in the world decides. */
        private double doubt;

        /** Whether all lines that go into the body certainly leave it. */
        private boolean isLeftByAll;

        @Override
        void dim(double passing, Shaft ofShaft, LightSamples points) {
            for (int i = 0; i < points.count; i++) {
                if (points.transmittance[i] > 0 && isCrossed(points.x[i], points.y[i], ofShaft)) {
                    points.transmittance[i] *= passing;
                }
            }
        }

        private boolean isCrossed(double x, double y, Shaft ofShaft) {
            double endHeight = height + x * alongU + y * alongV;
            boolean isClear = Math.abs(endHeight) > doubt;
            if (isClear && (endHeight > 0 || isLeftByAll)) {
                return endHeight < 0;
            }
            return scene.isOwnSurfaceCrossed(ofShaft.hit, ofShaft.segmentTo(x, y));
        }
    }

    final Shaft shaft = new Shaft();
    final SphereObstacles spheres;
    final PlaneObstacles planes;
    final BoxObstacles boxes;
    final TriangleObstacles triangles;
    private final PreparedScene scene;
    private final Use use;
    private final boolean hasTriangles;

    /** Of a mesh, so many triangles are sorted at most; of triangles without a hierarchy, as many as of all obstacles. */
    private final int mostTriangles;
    private final boolean usesShafts;
    private final CrossedSurfaces certain;
    private final double[] transmittanceOf;
    private final LightSamples samples = new LightSamples();
    private final OwnBody ownBody = new OwnBody();
    private Obstacles.Obstacle[] transparent = new Obstacles.Obstacle[4];
    private final Obstacles<?>[] kinds;

    /** What is known of shafts near the last ones, by light and surface; empty where hierarchies or groups find the surfaces. */
    private final NearbyShafts[] nearby;

    private final SegmentQuery segmentQuery;
    private final PyramidTraversal traversal = new PyramidTraversal();

    private boolean isSorted;
    private boolean isNarrowerThanRounding;
    private boolean ownBodyIsObstacle;
    private double settledTransmittance;

    /**
     * For each light, whether lines find the answer sooner: among many surfaces, the shaft next to a dark one is mostly dark
     * too, and the shaft next to one that has too many triangles in it, to a border of a mesh's shadow, has too many too.
     */
    private final boolean[] areLinesSooner;

    /** Number of the light that the shaft leads to. */
    private int light;

    /** A shaft that is not aimed, for so many lights. */
    ShaftQuery(PreparedScene scene, Use use, int lightCount) {
        this(scene, use, use.mostObstacles, lightCount);
    }

    /** The same for so many lines to each light: fewer lines are tested sooner than more triangles of a mesh are sorted. */
    ShaftQuery(PreparedScene scene, Use use, int lines, int lightCount) {
        this.scene = scene;
        this.use = use;
        mostTriangles = scene.triangles().hierarchy().isPresent() ? Math.min(lines, use.mostObstacles) : use.mostObstacles;
        usesShafts = scene.uses(Shortcut.SHADOW_SHAFTS);
        spheres = new SphereObstacles(shaft, scene);
        planes = new PlaneObstacles(shaft, scene);
        boxes = new BoxObstacles(shaft, scene);
        triangles = new TriangleObstacles(shaft, scene);
        hasTriangles = scene.hasTriangles();
        kinds = hasTriangles ? new Obstacles<?>[] {planes, spheres, boxes, triangles}
            : new Obstacles<?>[] {planes, spheres, boxes};
        certain = new CrossedSurfaces(scene.transmittances());
        transmittanceOf = scene.transmittances();
        segmentQuery = new SegmentQuery(scene, lightCount);
        areLinesSooner = new boolean[lightCount];
        boolean areFew = !scene.hasHierarchy() && scene.planes().groups().isEmpty();
        nearby = new NearbyShafts[usesShafts && areFew ? NEARBY : 0];
        for (int i = 0; i < nearby.length; i++) {
            nearby[i] = new NearbyShafts();
        }
    }

    /** Forgets earlier shafts, which decide how the next answer is found, and never the answer. */
    void forgetPast() {
        Arrays.fill(areLinesSooner, false);
        for (NearbyShafts shafts : nearby) {
            shafts.clear();
        }
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
        certain.clear();
        Surface own = scene.surface(hit.surface());
        boolean isSeenFromInside = hit.side() == Departure.INWARD && own instanceof Body;
        int place = (hit.surface() + LIGHTS_APART * light) & (NEARBY - 1);
        boolean isNear = nearby.length > 0 && nearby[place].holds(light, hit);
        if (isNear) {
            find(nearby[place], hit.surface());
            if (nearby[place].areClear()
                    && !((isSeenFromInside || !nearby[place].isWhollySeen(hit)) && own instanceof Bounded)) {
                settleInLight();
                return;
            }
        } else if (nearby.length > 0) {
            nearby[place].begin(light, hit, lightX, lightY, lightZ, error, width);
        }
        shaft.aim(hit, lightX, lightY, lightZ, error, width);
        isNarrowerThanRounding = shaft.isNarrowerThanRounding();
        Basis axes = shaft.axes;
        double height = hit.alongNormal(shaft.tx, shaft.ty, shaft.tz);
        double alongU = hit.alongNormal(axes.ux(), axes.uy(), axes.uz());
        double alongV = hit.alongNormal(axes.vx(), axes.vy(), axes.vz());
        double spread = shaft.halfWidth * (Math.abs(alongU) + Math.abs(alongV));
        boolean isWhollySeen = height - spread > shaft.margin;
        ownBodyIsObstacle = false;
        if ((isSeenFromInside || !isWhollySeen) && own instanceof Bounded) {
            boolean isLeftByAll = !(own instanceof Body body) || shaft.endsApartFrom(body);
            ownBodyIsObstacle = !(isSeenFromInside && isLeftByAll);
            if (ownBodyIsObstacle) {
                ownBody.number = hit.surface();
                ownBody.height = height;
                ownBody.alongU = alongU;
                ownBody.alongV = alongV;
                ownBody.doubt = isSeenFromInside ? Obstacles.ALWAYS_IN_DOUBT : planes.doubt(shaft.margin);
                ownBody.isLeftByAll = isLeftByAll;
            } else {
                certain.add(hit.surface());
            }
        }
        if (isNear) {
            planes.sort(nearby[place].planes, certain);
            spheres.sort(nearby[place].spheres, certain);
            boxes.sort(nearby[place].boxes, certain);
            if (hasTriangles) {
                triangles.sort(nearby[place].triangles, certain);
            }
            isSorted = knowsAll();
        } else {
            sortAll();
        }
        settledTransmittance = certain.transmittance();
    }

    private void find(NearbyShafts shafts, int surfaceLeft) {
        if (!shafts.areKnown()) {
            planes.find(shafts, surfaceLeft, shafts.planes);
            spheres.find(shafts, surfaceLeft, shafts.spheres);
            boxes.find(shafts, surfaceLeft, shafts.boxes);
            if (hasTriangles) {
                triangles.find(shafts, surfaceLeft, shafts.triangles);
            }
        }
    }

    private void settleInLight() {
        isSorted = true;
        isNarrowerThanRounding = false;
        ownBodyIsObstacle = false;
        planes.count = 0;
        spheres.count = 0;
        boxes.count = 0;
        triangles.count = 0;
        settledTransmittance = 1;
    }

    private void sortAll() {
        isSorted = use == Use.AREAS || usesShafts && !(areLinesSooner[light] && scene.hasHierarchy());
        if (isSorted) {
            planes.sort(use.mostObstacles, traversal, certain);
            spheres.sort(use.mostObstacles, traversal, certain);
            boxes.sort(use.mostObstacles - spheres.count, traversal, certain);
            if (hasTriangles) {
                triangles.sort(Math.min(mostTriangles, use.mostObstacles - spheres.count - boxes.count), traversal, certain);
            }
            areLinesSooner[light] = certain.isDark();
            isSorted = knowsAll();
        }
    }

    /** After sorting: whether no light is left, or there are so few obstacles that all of them are known. */
    private boolean knowsAll() {
        return certain.isDark() || triangles.count <= mostTriangles
            && spheres.count + boxes.count + triangles.count <= use.mostObstacles;
    }

    /** Whether rounding moves the light by more than its width, so that only a line to its middle makes sense. */
    boolean isNarrowerThanRounding() {
        return isNarrowerThanRounding;
    }

    /** Whether all lines cross the same surfaces, or all of them an opaque one. */
    boolean isSettled() {
        return certain.isDark()
            || isSorted && !ownBodyIsObstacle && spheres.count + planes.count + boxes.count + triangles.count == 0;
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
        int cells = root * root;
        double sum = 0;
        for (int first = 0; first < cells; first += LightSamples.MOST) {
            samples.place(first, Math.min(cells - first, LightSamples.MOST), root, shaft, key);
            findTransmittances(samples);
            sum = samples.addTo(sum);
        }
        areLinesSooner[light] = sum == 0 || !isSorted && sum < cells && scene.triangles().hierarchy().isPresent();
        return sum;
    }

    /**
     * Finds how much light comes through along the lines to points that nothing has dimmed yet. Opaque obstacles come first;
     * then transparent ones and the surfaces that all lines cross, in the order of the scene, on which a product of rounded
     * shares depends. Long on purpose, as {@link #aim} is.
     */
    void findTransmittances(LightSamples points) {
        if (!isSorted) {
            for (int i = 0; i < points.count; i++) {
                double x = points.x[i];
                double y = points.y[i];
                points.transmittance[i] = segmentQuery.transmittance(shaft.hit, light, shaft.endX(x, y), shaft.endY(x, y),
                    shaft.endZ(x, y), shaft.endError);
            }
            return;
        }
        int transparentCount = 0;
        if (ownBodyIsObstacle && transmittanceOf[ownBody.number] == 0) {
            ownBody.dim(0, shaft, points);
        } else if (ownBodyIsObstacle) {
            transparent[transparentCount++] = ownBody;
        }
        for (Obstacles<?> kind : kinds) {
            for (int i = 0; i < kind.count; i++) {
                Obstacles.Obstacle obstacle = kind.obstacles[i];
                if (transmittanceOf[obstacle.number] == 0) {
                    obstacle.dim(0, shaft, points);
                    continue;
                }
                if (transparentCount == transparent.length) {
                    transparent = Arrays.copyOf(transparent, 2 * transparentCount);
                }
                int at = transparentCount++;
                while (at > 0 && transparent[at - 1].number > obstacle.number) {
                    transparent[at] = transparent[at - 1];
                    at--;
                }
                transparent[at] = obstacle;
            }
        }
        int passed = 0;
        for (int i = 0; i < transparentCount; i++) {
            int number = transparent[i].number;
            passed = dimByCertain(passed, number, points);
            transparent[i].dim(transmittanceOf[number], shaft, points);
        }
        dimByCertain(passed, Integer.MAX_VALUE, points);
    }

    /** Dims by those surfaces that all lines cross whose numbers are below one; returns how many have dimmed so far. */
    private int dimByCertain(int passed, int below, LightSamples points) {
        int i = passed;
        while (i < certain.count() && certain.number(i) < below) {
            points.dimAll(transmittanceOf[certain.number(i)]);
            i++;
        }
        return i;
    }

    /** Whether the body that was hit hides some of the square. */
    boolean ownBodyIsObstacle() {
        return ownBodyIsObstacle;
    }
}
