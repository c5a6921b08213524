package raytracing.trace;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import raytracing.hierarchy.Bounds;
import raytracing.hierarchy.Hierarchy;
import raytracing.parallel.ForkJoin;
import raytracing.scene.Material;
import raytracing.scene.Scene;
import raytracing.surface.Body;
import raytracing.surface.Box;
import raytracing.surface.Departure;
import raytracing.surface.Hit;
import raytracing.surface.Plane;
import raytracing.surface.Segment;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;

/**
 * The surfaces of a scene made ready for queries: what does a ray meet next ({@link RayQuery}), and how much light comes
 * through between two points ({@link SegmentQuery}). Immutable.
 */
public final class PreparedScene {
    /** Fewer surfaces of a kind are tested one by one (measured: PERFORMANCE). */
    private static final int FEWEST_IN_A_HIERARCHY = 48;

    private final Surface[] surfaces;
    private final PlaneList planes;
    private final SphereList spheres;
    private final BoxList boxes;
    private final SurfaceList[] lists;
    private final boolean hasHierarchy;
    private final double[] transmittances;
    private final Set<Shortcut> shortcuts;

    /**
     * Prepares a scene.
     *
     * @param shadowMode what transparent surfaces do to light that falls through them
     * @param shortcuts those that may be taken: all, but to compare with
     * @param workers threads that build hierarchies; the result is the same
     */
    public PreparedScene(Scene scene, ShadowMode shadowMode, Set<Shortcut> shortcuts, ForkJoin workers) {
        this.shortcuts = shortcuts;
        surfaces = scene.surfaces().toArray(new Surface[0]);
        Kinds kinds = new Kinds(surfaces);
        Plane[] allPlanes = kinds.planes.toArray(new Plane[0]);
        Sphere[] allSpheres = kinds.spheres.toArray(new Sphere[0]);
        Box[] allBoxes = kinds.boxes.toArray(new Box[0]);
        workers.expect((needsHierarchy(allSpheres) ? allSpheres.length : 0)
            + (needsHierarchy(allBoxes) ? allBoxes.length : 0));
        int[] sphereNumbers = kinds.spheres.numbers();
        int[] boxNumbers = kinds.boxes.numbers();
        planes = new PlaneList(allPlanes, kinds.planes.numbers());
        spheres = new SphereList(allSpheres, sphereNumbers, arrange(allSpheres, sphereNumbers, workers));
        boxes = new BoxList(allBoxes, boxNumbers, arrange(allBoxes, boxNumbers, workers));
        lists = new SurfaceList[] {planes, spheres, boxes};
        hasHierarchy = spheres.hierarchy().isPresent() || boxes.hierarchy().isPresent();
        checkThatAllAreListed();
        transmittances = new double[surfaces.length];
        if (shadowMode == ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT) {
            List<Material> materials = scene.materials();
            for (int i = 0; i < transmittances.length; i++) {
                transmittances[i] = materials.get(surfaces[i].material()).transparency();
            }
        }
    }

    private void checkThatAllAreListed() {
        int count = 0;
        for (SurfaceList list : lists) {
            count += list.numbers().length;
        }
        if (count != surfaces.length) {
            throw new IllegalStateException("a kind of surface is in no list");
        }
    }

    private boolean needsHierarchy(Body[] bodies) {
        return bodies.length >= FEWEST_IN_A_HIERARCHY && shortcuts.contains(Shortcut.HIERARCHY);
    }

    /** Builds a hierarchy over many bodies, and brings them and their numbers in its order. */
    private Optional<Hierarchy> arrange(Body[] bodies, int[] numbers, ForkJoin workers) {
        if (!needsHierarchy(bodies)) {
            return Optional.empty();
        }
        Bounds bounds = new Bounds(bodies.length);
        for (int i = 0; i < bodies.length; i++) {
            bodies[i].bound(bounds, i);
        }
        Hierarchy hierarchy = Hierarchy.over(bounds, workers);
        int[] order = hierarchy.order();
        Body[] listed = bodies.clone();
        int[] listedNumbers = numbers.clone();
        for (int i = 0; i < order.length; i++) {
            bodies[i] = listed[order[i]];
            numbers[i] = listedNumbers[order[i]];
        }
        return Optional.of(hierarchy);
    }

    /** The surfaces of one kind and their numbers in the scene. */
    private static final class Kind<S extends Surface> extends ArrayList<S> {
        private static final long serialVersionUID = 1;

        private int[] numbers = new int[16];

        boolean add(S surface, int number) {
            if (size() == numbers.length) {
                numbers = Arrays.copyOf(numbers, 2 * size());
            }
            numbers[size()] = number;
            return add(surface);
        }

        int[] numbers() {
            return Arrays.copyOf(numbers, size());
        }
    }

    /** Sorts the surfaces by kind. */
    private static final class Kinds implements Surface.Visitor<Boolean> {
        private final Kind<Sphere> spheres = new Kind<>();
        private final Kind<Plane> planes = new Kind<>();
        private final Kind<Box> boxes = new Kind<>();
        private int number;

        Kinds(Surface[] surfaces) {
            for (number = 0; number < surfaces.length; number++) {
                surfaces[number].accept(this);
            }
        }

        @Override
        public Boolean visit(Sphere sphere) {
            return spheres.add(sphere, number);
        }

        @Override
        public Boolean visit(Plane plane) {
            return planes.add(plane, number);
        }

        @Override
        public Boolean visit(Box box) {
            return boxes.add(box, number);
        }
    }

    public boolean uses(Shortcut shortcut) {
        return shortcuts.contains(shortcut);
    }

    public Surface surface(int number) {
        return surfaces[number];
    }

    /** All surfaces by their number in the scene. */
    Surface[] surfaces() {
        return surfaces;
    }

    /** The lists of all kinds. */
    SurfaceList[] lists() {
        return lists;
    }

    public PlaneList planes() {
        return planes;
    }

    public SphereList spheres() {
        return spheres;
    }

    public BoxList boxes() {
        return boxes;
    }

    /** Whether there are so many surfaces of a kind that a hierarchy finds them. */
    public boolean hasHierarchy() {
        return hasHierarchy;
    }

    /** The share of light that each surface lets through, by its number in the scene; in [0, 1]. */
    public double[] transmittances() {
        return transmittances;
    }

    /**
     * Whether a segment from a hit crosses the body of the surface that was hit: from inside, if it ends outside; from
     * outside, if it goes through from wall to wall.
     */
    public boolean isOwnBodyCrossed(Hit hit, Segment segment) {
        return (hit.side() == Departure.INWARD
            || hit.departureTowards(segment.dx(), segment.dy(), segment.dz()) == Departure.INWARD)
            && surfaces[hit.surface()] instanceof Body body && body.isLeft(segment);
    }
}
