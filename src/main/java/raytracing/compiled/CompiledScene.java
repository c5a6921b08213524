package raytracing.compiled;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import raytracing.geometry.Box;
import raytracing.geometry.Departure;
import raytracing.geometry.HitPoint;
import raytracing.geometry.Plane;
import raytracing.geometry.Sphere;
import raytracing.geometry.Surface;
import raytracing.scene.Material;
import raytracing.scene.Scene;

/**
 * The surfaces of a scene behind the two questions that shading asks: what does a ray meet next ({@link RayWalk}), and how
 * much light comes through between two points ({@link ShadowLine}, {@link ShadowShaft}). One array for each kind keeps the
 * calls in the loops to a single receiver, which the virtual machine can inline; the kernels are those of the
 * objects, so the answers are theirs, bit for bit. Immutable.
 */
public final class CompiledScene {
    private final Surface[] surfaces;
    private final SphereArray spheres;
    private final PlaneArray planes;
    private final BoxArray boxes;
    private final double[] transmittanceOf;
    private final Set<Shortcut> shortcuts;

    /**
     * Sorts the surfaces of a scene by kind.
     *
     * @param scene the scene
     * @param shadowMode what transparent surfaces do to light that falls through them
     */
    public CompiledScene(Scene scene, ShadowMode shadowMode) {
        this(scene, shadowMode, EnumSet.allOf(Shortcut.class));
    }

    /**
     * The same with some shortcuts only, to compare with.
     *
     * @param scene the scene
     * @param shadowMode what transparent surfaces do to light that falls through them
     * @param shortcuts those that may be taken
     */
    public CompiledScene(Scene scene, ShadowMode shadowMode, Set<Shortcut> shortcuts) {
        this.shortcuts = shortcuts;
        surfaces = scene.surfaces().toArray(new Surface[0]);
        Sorter sorter = new Sorter();
        for (Surface surface : surfaces) {
            surface.presentTo(sorter);
            sorter.number++;
        }
        spheres = new SphereArray(sorter.spheres, numbers(sorter.sphereNumbers));
        planes = new PlaneArray(sorter.planes, numbers(sorter.planeNumbers));
        boxes = new BoxArray(sorter.boxes, numbers(sorter.boxNumbers));
        transmittanceOf = new double[surfaces.length];
        if (shadowMode == ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT) {
            List<Material> materials = scene.materials();
            for (int i = 0; i < transmittanceOf.length; i++) {
                transmittanceOf[i] = materials.get(surfaces[i].material()).transparency();
            }
        }
    }

    private static int[] numbers(List<Integer> list) {
        int[] numbers = new int[list.size()];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = list.get(i);
        }
        return numbers;
    }

    private static final class Sorter implements Surface.Receiver {
        private final List<Sphere> spheres = new ArrayList<>();
        private final List<Integer> sphereNumbers = new ArrayList<>();
        private final List<Plane> planes = new ArrayList<>();
        private final List<Integer> planeNumbers = new ArrayList<>();
        private final List<Box> boxes = new ArrayList<>();
        private final List<Integer> boxNumbers = new ArrayList<>();
        private int number;

        @Override
        public void sphere(Sphere sphere) {
            spheres.add(sphere);
            sphereNumbers.add(number);
        }

        @Override
        public void plane(Plane plane) {
            planes.add(plane);
            planeNumbers.add(number);
        }

        @Override
        public void box(Box box) {
            boxes.add(box);
            boxNumbers.add(number);
        }
    }

    boolean uses(Shortcut shortcut) {
        return shortcuts.contains(shortcut);
    }

    Surface surface(int number) {
        return surfaces[number];
    }

    boolean isPlane(int number) {
        return surfaces[number] instanceof Plane;
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
    void offerCrossings(RayWalk ray, HierarchyWalk walk, Nearest nearest) {
        planes.offerCrossings(ray, nearest);
        spheres.offerCrossings(ray, 0, spheres.count(), nearest);
        boxes.offerCrossings(ray, 0, boxes.count(), nearest);
    }

    /** Adds all surfaces that a line crosses, but for the one it leaves; may stop when no light is left. */
    void addCrossed(ShadowLine line) {
        planes.addCrossed(line);
        spheres.addCrossed(line, 0, spheres.count());
        boxes.addCrossed(line, 0, boxes.count());
    }

    /** Adds all surfaces that lines of a shaft may cross, but for the one they leave; may stop when no light is left. */
    void addTouched(ShadowShaft shaft) {
        planes.addTouched(shaft);
        spheres.addTouched(shaft, 0, spheres.count());
        boxes.addTouched(shaft, 0, boxes.count());
    }

    /** Whether a straight line from a hit goes through the body of the surface that was hit, from wall to wall. */
    boolean isOwnBodyCrossed(HitPoint hit, int surface, double qx, double qy, double qz, double endError) {
        return hit.departureTowards(qx - hit.x(), qy - hit.y(), qz - hit.z()) == Departure.INWARD
            && surfaces[surface].isLeftBefore(qx, qy, qz, endError);
    }
}
