package raytracing.outline;

import java.util.Arrays;
import java.util.Optional;
import raytracing.hierarchy.ConeTraversal;
import raytracing.hierarchy.Hierarchy;
import raytracing.math.Vector;
import raytracing.outline.Sight.Cover;
import raytracing.outline.SquareCone.View;
import raytracing.scene.CameraRays;
import raytracing.scene.Scene;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.PointError;
import raytracing.surface.Ray;
import raytracing.surface.Sphere;
import raytracing.surface.Triangle;
import raytracing.trace.PreparedScene;

/**
 * Tells which pixels of a picture may hold an outline: where two rays through the pixel's square, its border included, meet
 * different lists of surfaces, or different faces of a box. A list begins with the nearest surface and ends with the first
 * opaque one or the background. Mirrors and shadows are not looked at. The answer is never "no outline" if there is one
 * (proved but for the rounding of hits, which is measured; SAMPLING); it is seldom "maybe" if there is none.
 *
 * <p>A block of the picture is a square that is divided in four, again and again, down to single pixels. Each square passes
 * on the surfaces that its cone may see: those not beside the cone, and not behind an opaque surface before all of it. A
 * square whose rays certainly see the same is not divided; so the work grows with the length of the outlines. The answer
 * for a pixel depends on scene, picture size and pixel alone. Does not allocate. Not thread-safe.
 */
public final class OutlineQuery {
    /** Edge of a block in pixels. */
    public static final int BLOCK = 16;

    /** The most rays that a pixel is said to need. */
    public static final int MOST_RAYS = SmallBodies.MOST;

    /** How often a block is halved until its squares are pixels, and until they are the smallest parts of pixels. */
    private static final int TO_PIXELS = 4;
    private static final int DIVISIONS = TO_PIXELS + 2;

    /**
     * So many bodies of a hierarchy may be seen in one square; if there are more, its quarters ask the hierarchy
     * themselves.
     */
    private static final int MOST_FOUND = 128;

    /** Surfaces that touch the eye within so many errors of its coordinates count as unknown. */
    private static final double TOUCHING = 16;

    private static final double STEPS = 255;

    private final Sphere[] spheres;
    private final Box[] boxes;
    private final Triangle[] triangles;
    private final Plane[] planes;
    private final int planeCount;
    private final Optional<Hierarchy> sphereHierarchy;
    private final Optional<Hierarchy> boxHierarchy;
    private final Optional<Hierarchy> triangleHierarchy;
    private final boolean[] isOpaque;
    private final double leastSteps;
    private final double eyeError;
    private final int width;
    private final int height;

    private final SquareCone cone;
    private final PlaneSight planeSight;
    private final SphereSight sphereSight;
    private final BoxSight boxSight;
    private final TriangleSight triangleSight;
    private final SmallBodies smallBodies;
    private final ConeTraversal traversal = new ConeTraversal();
    private final Sight sight = new Sight();

    /** For each size of squares, the surfaces that the square around may see; numbered planes first, then spheres,
        boxes and triangles. */
    private final int[][] seen = new int[DIVISIONS + 1][];
    private final int[] seenCounts = new int[DIVISIONS + 1];

    /** For each size of squares, a distance beyond which nothing is seen. */
    private final double[] ends = new double[DIVISIONS + 1];
    private final boolean[] asksForSpheres = new boolean[DIVISIONS + 1];
    private final boolean[] asksForBoxes = new boolean[DIVISIONS + 1];
    private final boolean[] asksForTriangles = new boolean[DIVISIONS + 1];

    /** The surfaces that the present square may see, and how. */
    private final int[] entries;
    private final Cover[] covers;
    private final double[] froms;
    private final double[] tos;
    private final double[] flatX;
    private final double[] flatY;
    private final double[] flatZ;
    private final double[] flatErrors;
    private int count;

    /** The opaque surface that covers all of the square and ends first, by its place among the entries, or -1. */
    private int wall;
    private double end;
    private boolean isOverfullOfSpheres;
    private boolean isOverfullOfBoxes;
    private boolean isOverfullOfTriangles;

    /** Whether the square may show something that is not among the entries. */
    private boolean isOpen;

    /** Whether all its rays certainly see the same. */
    private boolean isCertain;

    private final short[] answers = new short[BLOCK * BLOCK];
    private int left;
    private int top;

    /** Where the picture ends, from the corner of the block, in parts of a pixel; at most the block's own edge. */
    private int right;
    private int bottom;

    /**
     * Prepares queries for a picture.
     *
     * @param prepared the surfaces of the scene
     * @param rays of the scene's camera
     * @param leastSteps bodies that cannot fill more than this many steps of 1/255 of a pixel are not looked for, unless all
     *        those of the pixel together can; at least 0
     */
    public OutlineQuery(PreparedScene prepared, Scene scene, CameraRays rays, double leastSteps) {
        this.leastSteps = leastSteps;
        spheres = prepared.spheres().spheres();
        boxes = prepared.boxes().boxes();
        triangles = prepared.triangles().triangles();
        planes = prepared.planes().planes();
        planeCount = planes.length;
        sphereHierarchy = prepared.spheres().hierarchy();
        boxHierarchy = prepared.boxes().hierarchy();
        triangleHierarchy = prepared.triangles().hierarchy();
        isOpaque = new boolean[scene.materials().size()];
        for (int i = 0; i < isOpaque.length; i++) {
            isOpaque[i] = scene.materials().get(i).transparency() == 0;
        }
        width = rays.width();
        height = rays.height();
        cone = new SquareCone(rays);
        smallBodies = new SmallBodies(rays);
        Vector eye = rays.camera().position();
        eyeError = PointError.written(eye);
        sphereSight = new SphereSight(cone, TOUCHING * eyeError);
        boxSight = new BoxSight(cone, TOUCHING * eyeError);
        triangleSight = new TriangleSight(cone, TOUCHING * eyeError);
        Ray ray = new Ray();
        ray.startAt(eye, 0, 0, 1);
        planeSight = new PlaneSight(cone, planes, prepared.planes().numbers(), ray.origin());
        int most = planeCount + room(spheres.length, sphereHierarchy) + room(boxes.length, boxHierarchy)
            + room(triangles.length, triangleHierarchy);
        for (int i = 0; i < seen.length; i++) {
            seen[i] = new int[most];
        }
        entries = new int[most];
        covers = new Cover[most];
        froms = new double[most];
        tos = new double[most];
        flatX = new double[most];
        flatY = new double[most];
        flatZ = new double[most];
        flatErrors = new double[most];
        listAll();
    }

    private static int room(int bodies, Optional<Hierarchy> hierarchy) {
        return hierarchy.isPresent() ? MOST_FOUND : bodies;
    }

    /** Lists all surfaces that are in no hierarchy for the first square of every block. */
    private void listAll() {
        int[] all = seen[0];
        int n = 0;
        for (int i = 0; i < planeCount; i++) {
            all[n++] = i;
        }
        for (int i = 0; i < spheres.length && sphereHierarchy.isEmpty(); i++) {
            all[n++] = planeCount + i;
        }
        for (int i = 0; i < boxes.length && boxHierarchy.isEmpty(); i++) {
            all[n++] = planeCount + spheres.length + i;
        }
        for (int i = 0; i < triangles.length && triangleHierarchy.isEmpty(); i++) {
            all[n++] = planeCount + spheres.length + boxes.length + i;
        }
        seenCounts[0] = n;
        ends[0] = Double.POSITIVE_INFINITY;
        asksForSpheres[0] = sphereHierarchy.isPresent();
        asksForBoxes[0] = boxHierarchy.isPresent();
        asksForTriangles[0] = triangleHierarchy.isPresent();
    }

    /**
     * Finds the outlines of the block that holds the pixels from ({@value #BLOCK} blockX, {@value #BLOCK} blockY) on. Those
     * beyond the picture are left out.
     */
    public void aim(int blockX, int blockY) {
        left = BLOCK * blockX;
        top = BLOCK * blockY;
        right = SquareCone.PARTS * Math.min(BLOCK, width - left);
        bottom = SquareCone.PARTS * Math.min(BLOCK, height - top);
        cone.begin(left, top);
        divide(0, 0, 0, View.BORDER);
    }

    /**
     * How many rays notice every outline in a pixel of the block: a power of four.
     *
     * @return 1 if all rays see the same; otherwise at least {@value SmallBodies#FEWEST}, and at most
     *         {@value SmallBodies#MOST}: so many that one in a (0, 2)-net of them, in this pixel or the next, hits the ball
     *         inscribed in each small body that may be seen in part; of a triangle, a ball as wide as the disc in it, which may
     *         be missed if it is seen from aside
     */
    public int raysNeeded(int x, int y) {
        return answers[BLOCK * (y - top) + (x - left)];
    }

    /**
     * Answers for all pixels of a square that is a pixel or more.
     *
     * @param x0 its corner, from that of the block, in parts of a pixel
     * @param around what the square around shows
     */
    private void divide(int division, int x0, int y0, View around) {
        int half = BLOCK * SquareCone.PARTS >> division + 1;
        if (x0 >= right || y0 >= bottom) {
            return;
        }
        View view = look(division, x0, y0, around);
        if (isCertain) {
            answer(division, x0, y0, 1);
        } else if (division == TO_PIXELS) {
            int rays = isOpen ? Math.max(SmallBodies.FEWEST, raysForSurfaces()) : raysForSurfaces();
            answer(division, x0, y0, rays == 1 || areQuartersCertain(division, x0, y0, view) ? 1 : rays);
        } else {
            passOn(division + 1);
            divide(division + 1, x0, y0, view);
            divide(division + 1, x0 + half, y0, view);
            divide(division + 1, x0, y0 + half, view);
            divide(division + 1, x0 + half, y0 + half, view);
        }
    }

    /**
     * Whether all rays through a pixel, or a part of one, see the same, by looking at its quarters. Neighbouring quarters
     * share rays; so if each of them sees one list, all see the same one.
     */
    private boolean areQuartersCertain(int division, int x0, int y0, View view) {
        if (division == DIVISIONS) {
            return false;
        }
        int half = BLOCK * SquareCone.PARTS >> division + 1;
        boolean knowsAll = !isOpen;
        passOn(division + 1);
        if (knowsAll && isCrossed(division + 1)) {
            return false;
        }
        return isCertain(division + 1, x0, y0, view) && isCertain(division + 1, x0 + half, y0, view)
            && isCertain(division + 1, x0, y0 + half, view) && isCertain(division + 1, x0 + half, y0 + half, view);
    }

    /**
     * Whether the circle inside the square may hold an outline, too. Then one nearly always runs through the square, and to
     * look at its quarters is a waste.
     */
    private boolean isCrossed(int division) {
        cone.narrow();
        findSurfaces(division, View.LIT);
        return !areAllCovering();
    }

    private boolean isCertain(int division, int x0, int y0, View around) {
        View view = look(division, x0, y0, around);
        return isCertain || areQuartersCertain(division, x0, y0, view);
    }

    private void answer(int division, int x0, int y0, int rays) {
        int size = BLOCK >> division;
        for (int y = y0 / SquareCone.PARTS; y < y0 / SquareCone.PARTS + size; y++) {
            int from = BLOCK * y + x0 / SquareCone.PARTS;
            Arrays.fill(answers, from, from + size, (short) rays);
        }
    }

    /** Notes what the present square may see for its quarters. */
    private void passOn(int division) {
        System.arraycopy(entries, 0, seen[division], 0, count);
        seenCounts[division] = count;
        ends[division] = end;
        asksForSpheres[division] = isOverfullOfSpheres;
        asksForBoxes[division] = isOverfullOfBoxes;
        asksForTriangles[division] = isOverfullOfTriangles;
    }

    /** Finds what a square sees, among the surfaces that the square around may see; returns what the lens shows of it. */
    private View look(int division, int x0, int y0, View around) {
        int size = BLOCK * SquareCone.PARTS >> division;
        View view = cone.aim(x0, y0, Math.min(x0 + size, right), Math.min(y0 + size, bottom), around);
        if (view != View.BLACK) {
            findSurfaces(division, view);
        }
        isOpen = view != View.LIT || isOverfullOfSpheres || isOverfullOfBoxes || isOverfullOfTriangles;
        isCertain = view == View.BLACK || !isOpen && isUniform();
        return view;
    }

    private void findSurfaces(int division, View view) {
        count = 0;
        wall = -1;
        end = ends[division];
        isOverfullOfSpheres = asksForSpheres[division];
        isOverfullOfBoxes = asksForBoxes[division];
        isOverfullOfTriangles = asksForTriangles[division];
        int[] candidates = seen[division];
        int candidateCount = seenCounts[division];
        if (view == View.TOO_WIDE) {
            System.arraycopy(candidates, 0, entries, 0, candidateCount);
            Arrays.fill(covers, 0, candidateCount, Cover.SOME);
            count = candidateCount;
            return;
        }
        boxSight.aim();
        for (int i = 0; i < candidateCount; i++) {
            test(candidates[i]);
        }
        if (isOverfullOfSpheres) {
            isOverfullOfSpheres = !findBodies(sphereHierarchy.get(), planeCount);
        }
        if (isOverfullOfBoxes) {
            isOverfullOfBoxes = !findBodies(boxHierarchy.get(), planeCount + spheres.length);
        }
        if (isOverfullOfTriangles) {
            isOverfullOfTriangles = !findBodies(triangleHierarchy.get(), planeCount + spheres.length + boxes.length);
        }
        leaveOutHidden(0);
    }

    /**
     * Adds the bodies of a hierarchy that the square may see; if there are too many, none.
     *
     * @param first number of the hierarchy's first body
     * @return whether all were added
     */
    private boolean findBodies(Hierarchy hierarchy, int first) {
        int begin = count;
        traversal.startCone(hierarchy, cone.eyeX, cone.eyeY, cone.eyeZ, cone.axisX, cone.axisY, cone.axisZ, cone.sine,
            cone.cosine, TOUCHING * eyeError, end);
        while (traversal.nextLeaf()) {
            for (int i = traversal.from(); i < traversal.to(); i++) {
                if (count == begin + MOST_FOUND) {
                    leaveOutHidden(begin);
                }
                if (count == begin + MOST_FOUND) {
                    count = begin;
                    wall = wall < begin ? wall : -1;
                    return false;
                }
                test(first + i);
            }
            traversal.endAt(end);
        }
        return true;
    }

    /** Tests one surface, and adds it if the square may see it. */
    private void test(int entry) {
        int material;
        if (entry < planeCount) {
            planeSight.test(entry, sight);
            material = planes[entry].material();
        } else if (entry < planeCount + spheres.length) {
            Sphere sphere = spheres[entry - planeCount];
            sphereSight.test(sphere, sight);
            material = sphere.material();
        } else if (entry < planeCount + spheres.length + boxes.length) {
            Box box = boxes[entry - planeCount - spheres.length];
            boxSight.test(box, sight);
            material = box.material();
        } else {
            Triangle triangle = triangles[entry - planeCount - spheres.length - boxes.length];
            triangleSight.test(triangle, sight);
            material = triangle.material();
        }
        if (sight.cover == Cover.NONE || sight.from > end) {
            return;
        }
        if (sight.cover == Cover.ALL && isOpaque[material] && (wall < 0 || sight.to < tos[wall])) {
            wall = count;
            end = Math.min(end, sight.to);
        }
        entries[count] = entry;
        covers[count] = sight.cover;
        froms[count] = sight.from;
        tos[count] = sight.to;
        flatX[count] = sight.px;
        flatY[count] = sight.py;
        flatZ[count] = sight.pz;
        flatErrors[count] = sight.flatError;
        count++;
    }

    /** Leaves out those entries from a first one on that are certainly behind an opaque surface before the whole square. */
    private void leaveOutHidden(int first) {
        int kept = first;
        for (int i = first; i < count; i++) {
            boolean isWall = i == wall;
            if (isWall || !(froms[i] > end || wall >= 0 && isBefore(wall, i))) {
                move(i, kept);
                wall = isWall ? kept : wall;
                kept++;
            }
        }
        count = kept;
    }

    private void move(int i, int target) {
        entries[target] = entries[i];
        covers[target] = covers[i];
        froms[target] = froms[i];
        tos[target] = tos[i];
        flatX[target] = flatX[i];
        flatY[target] = flatY[i];
        flatZ[target] = flatZ[i];
        flatErrors[target] = flatErrors[i];
    }

    /** Whether all rays meet one entry, which covers the square, certainly before another. */
    private boolean isBefore(int i, int other) {
        if (tos[i] < froms[other]) {
            return true;
        }
        double error = flatErrors[i] + flatErrors[other];
        if (!(error < Double.POSITIVE_INFINITY)) {
            return false;
        }
        double x = flatX[i] - flatX[other];
        double y = flatY[i] - flatY[other];
        double z = flatZ[i] - flatZ[other];
        return cone.leastProduct(cone.along(x, y, z), cone.across(x, y, z)) > error;
    }

    /** Whether all entries cover the square and are met in the same order by all rays. */
    private boolean isUniform() {
        return areAllCovering() && areOrdered();
    }

    private boolean areAllCovering() {
        for (int i = 0; i < count; i++) {
            if (covers[i] != Cover.ALL) {
                return false;
            }
        }
        return true;
    }

    /** Whether those entries that cover the square are met in the same order by all rays. */
    private boolean areOrdered() {
        for (int i = 1; i < count; i++) {
            for (int j = 0; j < i; j++) {
                if (covers[i] == Cover.ALL && covers[j] == Cover.ALL && !isBefore(i, j) && !isBefore(j, i)) {
                    return false;
                }
            }
        }
        return true;
    }

    /** The rays that a pixel needs for the surfaces that may be seen in a part of it, or in an order that is not certain. */
    private int raysForSurfaces() {
        int rays = areOrdered() ? 1 : SmallBodies.FEWEST;
        int raysForTiny = 1;
        double tinyArea = 0;
        for (int i = 0; i < count; i++) {
            if (covers[i] != Cover.ALL) {
                lookAtBody(entries[i]);
                if (smallBodies.area() * STEPS < leastSteps) {
                    tinyArea += smallBodies.area();
                    raysForTiny = Math.max(raysForTiny, smallBodies.rays());
                } else {
                    rays = Math.max(rays, smallBodies.rays());
                }
            }
        }
        return tinyArea * STEPS < leastSteps ? rays : Math.max(rays, raysForTiny);
    }

    private void lookAtBody(int entry) {
        if (entry < planeCount) {
            smallBodies.lookAtEndless();
        } else if (entry < planeCount + spheres.length) {
            Sphere sphere = spheres[entry - planeCount];
            lookAtBody(sphere.centre(), sphere.radius(), sphere.radius());
        } else if (entry < planeCount + spheres.length + boxes.length) {
            Box box = boxes[entry - planeCount - spheres.length];
            lookAtBody(box.centre(), 0.5 * box.edge(), BoxSight.HALF_DIAGONAL * (0.5 * box.edge()));
        } else {
            Triangle triangle = triangles[entry - planeCount - spheres.length - boxes.length];
            lookAtBody(new Vector(triangle.middleX(), triangle.middleY(), triangle.middleZ()), triangle.inradius(),
                triangle.radius());
        }
    }

    private void lookAtBody(Vector centre, double inner, double outer) {
        smallBodies.look(centre.x() - cone.eyeX, centre.y() - cone.eyeY, centre.z() - cone.eyeZ, inner, outer);
    }
}
