package raytracing.shadow;

import java.util.Arrays;
import raytracing.area.ConvexShadows;
import raytracing.hierarchy.PyramidTraversal;
import raytracing.math.Basis;
import raytracing.surface.Hit;
import raytracing.trace.CrossedSurfaces;
import raytracing.trace.PreparedScene;
import raytracing.trace.Shortcut;
import raytracing.trace.SurfaceList;

/**
 * The surfaces of one kind that some lines of a shaft cross and others may not. Objects are reused from shaft to shaft, so a
 * shaft allocates nothing. Not thread-safe.
 *
 * @param <O> what is known of one obstacle
 */
abstract class Obstacles<O extends Obstacles.Obstacle> {
    /** What is known of a surface and the present shaft. */
    abstract static class Obstacle {
        /** Of the surface in the scene. */
        int number;

        /**
         * Dims the points of the light whose lines from the hit cross the surface; dark ones are left out. Each kind has a loop
         * of its own, so that the calls in it have a single receiver, which the virtual machine can inline.
         *
         * @param passing the share of light that the surface lets through
         */
        abstract void dim(double passing, Shaft shaft, LightSamples samples);
    }

    static final double ALWAYS_IN_DOUBT = Double.POSITIVE_INFINITY;

    final Shaft shaft;

    /** The first {@link #count} are in use. */
    O[] obstacles;
    int count;
    private final SurfaceList list;
    private final boolean usesOwnCoordinates;

    /**
     * No obstacles.
     *
     * @param list all surfaces of the kind
     * @param none an empty array
     */
    Obstacles(Shaft shaft, PreparedScene scene, SurfaceList list, O[] none) {
        this.shaft = shaft;
        this.list = list;
        obstacles = none;
        usesOwnCoordinates = scene.uses(Shortcut.SHAFT_COORDINATES);
    }

    /**
     * Sorts all surfaces of the kind anew, but for the one that the shaft's lines leave: those that all lines cross are added
     * to {@code certain}, those beside the shaft are left out, all others become obstacles. Stops where no light is left, and
     * in a hierarchy behind more than {@code most} obstacles.
     */
    final void sort(int most, PyramidTraversal traversal, CrossedSurfaces certain) {
        int[] numbers = list.numbers();
        count = 0;
        if (list.hierarchy().isEmpty()) {
            sortAll(numbers, certain);
            return;
        }
        Hit apex = shaft.hit;
        Basis axes = shaft.axes;
        traversal.startPyramid(list.hierarchy().get(), apex.x(), apex.y(), apex.z(), axes.wx(), axes.wy(), axes.wz(),
            axes.ux(), axes.uy(), axes.uz(), axes.vx(), axes.vy(), axes.vz(), shaft.depth, shaft.halfWidth, shaft.margin);
        while (!certain.isDark() && count <= most && traversal.nextLeaf()) {
            sort(numbers, traversal.from(), traversal.to(), certain);
        }
    }

    /** The same where only some of the list are not certainly beside the shaft. */
    final void sort(NearbyShafts.Entries some, CrossedSurfaces certain) {
        int[] numbers = list.numbers();
        count = 0;
        for (int i = 0; i < some.count(); i++) {
            int place = some.place(i);
            sort(numbers, place, place + 1, certain);
        }
    }

    /** Finds the surfaces of the kind that are not certainly beside some shafts, but for the one that their lines leave. */
    final void find(NearbyShafts shafts, int surfaceLeft, NearbyShafts.Entries found) {
        int[] numbers = list.numbers();
        for (int i = 0; i < numbers.length; i++) {
            if (numbers[i] != surfaceLeft && !isBeside(i, shafts)) {
                found.add(i);
            }
        }
    }

    /** Whether the surface at a place of the list is certainly beside some shafts. */
    abstract boolean isBeside(int place, NearbyShafts shafts);

    /** Sorts a list without a hierarchy, whose surfaces have these numbers in the scene. */
    void sortAll(int[] numbers, CrossedSurfaces certain) {
        sort(numbers, 0, numbers.length, certain);
    }

    /** Sorts a range of the list, whose surfaces have these numbers in the scene. */
    abstract void sort(int[] numbers, int from, int to, CrossedSurfaces certain);

    /** One more obstacle, still to be described. */
    final O add(int number) {
        if (count == obstacles.length) {
            obstacles = Arrays.copyOf(obstacles, Math.max(4, 2 * count));
            for (int i = count; i < obstacles.length; i++) {
                obstacles[i] = create();
            }
        }
        O obstacle = obstacles[count++];
        obstacle.number = number;
        return obstacle;
    }

    abstract O create();

    /** The error within which the shaft's own coordinates leave a test to the world's: with that shortcut left out, always. */
    final double doubt(double error) {
        return usesOwnCoordinates ? error : ALWAYS_IN_DOUBT;
    }

    /** Adds the shadows of all obstacles on the light's square. */
    final void addShadows(double[] transmittanceOf, ConvexShadows shadows) {
        bringInSceneOrder();
        for (int i = 0; i < count; i++) {
            addShadow(obstacles[i], transmittanceOf[obstacles[i].number], shadows);
        }
    }

    /**
     * A hierarchy finds surfaces in another order than that of the scene, and a sum of rounded areas depends on it. They are
     * few, and mostly in order already.
     */
    private void bringInSceneOrder() {
        for (int i = 1; i < count; i++) {
            O obstacle = obstacles[i];
            int at = i;
            while (at > 0 && obstacles[at - 1].number > obstacle.number) {
                obstacles[at] = obstacles[at - 1];
                at--;
            }
            obstacles[at] = obstacle;
        }
    }

    /** Adds the shadow of an obstacle that lets this share of light through. */
    abstract void addShadow(O obstacle, double passing, ConvexShadows shadows);
}
