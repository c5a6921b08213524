package raytracing.compiled;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import raytracing.geometry.Answer;
import raytracing.geometry.Box;
import raytracing.geometry.Departure;
import raytracing.geometry.HitPoint;
import raytracing.geometry.Plane;
import raytracing.geometry.Sphere;
import raytracing.geometry.Surface;
import raytracing.math.Vector;
import raytracing.scene.Material;
import raytracing.scene.Scene;

/**
 * The surfaces of a scene behind the two questions that shading asks: what does a ray meet next ({@link RayWalk}), and how
 * much light comes through between two points ({@link ShadowLine}, {@link ShadowShaft}). One array for each kind keeps the
 * calls in the loops to a single receiver, which the virtual machine can inline; the kernels are those of the
 * objects, so the answers are theirs, bit for bit. Immutable.
 */
public final class CompiledScene {
    /** Fewer surfaces of a kind are asked one by one (measured: PERFORMANCE). */
    private static final int FEWEST_IN_A_HIERARCHY = 48;

    private final Surface[] surfaces;
    private final SphereArray spheres;
    private final PlaneArray planes;
    private final BoxArray boxes;
    private final double[] transmittanceOf;
    private final Set<Shortcut> shortcuts;

    /**
     * Sorts the surfaces of a scene by kind, with all shortcuts.
     *
     * @param scene the scene
     * @param shadowMode what transparent surfaces do to light that falls through them
     */
    public CompiledScene(Scene scene, ShadowMode shadowMode) {
        this(scene, shadowMode, EnumSet.allOf(Shortcut.class), Workers.ALONE);
    }

    /**
     * Sorts the surfaces of a scene by kind.
     *
     * @param scene the scene
     * @param shadowMode what transparent surfaces do to light that falls through them
     * @param shortcuts those that may be taken: all, but to compare with
     * @param workers who does it; the result is the same
     */
    public CompiledScene(Scene scene, ShadowMode shadowMode, Set<Shortcut> shortcuts, Workers workers) {
        this.shortcuts = shortcuts;
        surfaces = scene.surfaces().toArray(new Surface[0]);
        Sorter sorter = new Sorter(surfaces);
        workers.expect((needsHierarchy(sorter.spheres.length) ? sorter.spheres.length : 0)
            + (needsHierarchy(sorter.boxes.length) ? sorter.boxes.length : 0));
        spheres = new SphereArray(sorter.spheres, sorter.sphereNumbers,
            needsHierarchy(sorter.spheres.length)
                ? Optional.of(Hierarchy.over(SphereArray.bounds(sorter.spheres), workers)) : Optional.empty());
        planes = new PlaneArray(sorter.planes, sorter.planeNumbers);
        boxes = new BoxArray(sorter.boxes, sorter.boxNumbers,
            needsHierarchy(sorter.boxes.length)
                ? Optional.of(Hierarchy.over(BoxArray.bounds(sorter.boxes), workers)) : Optional.empty());
        transmittanceOf = new double[surfaces.length];
        if (shadowMode == ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT) {
            List<Material> materials = scene.materials();
            for (int i = 0; i < transmittanceOf.length; i++) {
                transmittanceOf[i] = materials.get(surfaces[i].material()).transparency();
            }
        }
    }

    private boolean needsHierarchy(int count) {
        return count >= FEWEST_IN_A_HIERARCHY && shortcuts.contains(Shortcut.HIERARCHY);
    }

    /** The surfaces of each kind and their numbers in the scene. */
    private static final class Sorter implements Surface.Receiver {
        private final Sphere[] spheres;
        private final int[] sphereNumbers;
        private final Plane[] planes;
        private final int[] planeNumbers;
        private final Box[] boxes;
        private final int[] boxNumbers;
        private int sphereCount;
        private int planeCount;
        private int boxCount;
        private int number;

        Sorter(Surface[] surfaces) {
            for (Surface surface : surfaces) {
                sphereCount += surface instanceof Sphere ? 1 : 0;
                planeCount += surface instanceof Plane ? 1 : 0;
                boxCount += surface instanceof Box ? 1 : 0;
            }
            spheres = new Sphere[sphereCount];
            sphereNumbers = new int[sphereCount];
            planes = new Plane[planeCount];
            planeNumbers = new int[planeCount];
            boxes = new Box[boxCount];
            boxNumbers = new int[boxCount];
            sphereCount = 0;
            planeCount = 0;
            boxCount = 0;
            for (number = 0; number < surfaces.length; number++) {
                surfaces[number].presentTo(this);
            }
        }

        @Override
        public void sphere(Sphere sphere) {
            sphereNumbers[sphereCount] = number;
            spheres[sphereCount++] = sphere;
        }

        @Override
        public void plane(Plane plane) {
            planeNumbers[planeCount] = number;
            planes[planeCount++] = plane;
        }

        @Override
        public void box(Box box) {
            boxNumbers[boxCount] = number;
            boxes[boxCount++] = box;
        }
    }

    boolean uses(Shortcut shortcut) {
        return shortcuts.contains(shortcut);
    }

    Surface surface(int number) {
        return surfaces[number];
    }

    Box box(int number) {
        return (Box) surfaces[number];
    }

    boolean isPlane(int number) {
        return surfaces[number] instanceof Plane;
    }

    /** Whether there are so many surfaces that a hierarchy finds them. */
    boolean hasHierarchy() {
        return spheres.hasHierarchy() || boxes.hasHierarchy();
    }

    SphereArray spheres() {
        return spheres;
    }

    PlaneArray planes() {
        return planes;
    }

    BoxArray boxes() {
        return boxes;
    }

    /** What every surface lets through of light, by its number. */
    double[] transmittances() {
        return transmittanceOf;
    }

    /** Offers the first crossing of a ray with every surface but the one it leaves. */
    void offerCrossings(RayWalk ray, HierarchyWalk walk, Crossings crossings) {
        planes.offerCrossings(ray, crossings);
        spheres.offerCrossings(ray, walk, crossings);
        boxes.offerCrossings(ray, walk, crossings);
    }

    /** Adds all surfaces that a line crosses, but for the one it leaves; may stop when no light is left. */
    void addCrossed(ShadowLine line, HierarchyWalk walk) {
        planes.addCrossed(line);
        spheres.addCrossed(line, walk);
        boxes.addCrossed(line, walk);
    }

    /** Adds all surfaces that lines of a shaft may cross, but for the one they leave; may stop when no light is left. */
    void addTouched(ShadowShaft shaft, PyramidWalk walk) {
        planes.addTouched(shaft);
        spheres.addTouched(shaft, walk);
        boxes.addTouched(shaft, walk);
    }

    /**
     * Whether a straight line from a hit crosses the body of the surface that was hit: from inside, if it ends outside; from
     * outside, if it goes through from wall to wall.
     */
    boolean isOwnBodyCrossed(HitPoint hit, double qx, double qy, double qz, double endError) {
        return (hit.side() == Departure.INWARD
            || hit.departureTowards(qx - hit.x(), qy - hit.y(), qz - hit.z()) == Departure.INWARD)
            && surfaces[hit.surface()].isLeftBefore(qx, qy, qz, endError);
    }

    /** Whether a straight line from a hit crosses another surface, given what doubles say; decided exactly if they cannot. */
    boolean isCrossed(Answer quick, HitPoint hit, int surface, double qx, double qy, double qz, double endError) {
        return quick == Answer.UNDECIDED
            ? surfaces[surface].isCrossedBetween(hit.place(), surface, new Vector(qx, qy, qz), endError) : quick == Answer.YES;
    }
}
