package raytracing.trace;

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
import raytracing.surface.Bounded;
import raytracing.surface.Box;
import raytracing.surface.Departure;
import raytracing.surface.Hit;
import raytracing.surface.Plane;
import raytracing.surface.Segment;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

/**
 * The surfaces of a scene made ready for queries: what does a ray meet next ({@link RayQuery}), and how much light comes
 * through between two points ({@link SegmentQuery}). Immutable.
 *
 * <p>Work that every scene needs is in anonymous classes: the first lambda of a program takes Java 10 ms.
 */
public final class PreparedScene {
    /** Fewer surfaces of a kind are tested one by one (measured: PERFORMANCE). */
    private static final int FEWEST_IN_A_HIERARCHY = 48;

    /** The same for planes. */
    private static final int FEWEST_IN_GROUPS = 16;

    private final Surface[] surfaces;
    private final PlaneList planes;
    private final SphereList spheres;
    private final BoxList boxes;
    private final TriangleList triangles;
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
        Kinds kinds = Kinds.of(surfaces, 0, surfaces.length, workers);
        int[] sphereNumbers = kinds.spheres.toArray();
        int[] boxNumbers = kinds.boxes.toArray();
        int[] triangleNumbers = kinds.triangles.toArray();
        workers.expect(countInHierarchy(sphereNumbers) + countInHierarchy(boxNumbers) + countInHierarchy(triangleNumbers));
        Optional<Hierarchy> overSpheres = arrange(sphereNumbers, workers);
        Optional<Hierarchy> overBoxes = arrange(boxNumbers, workers);
        Optional<Hierarchy> overTriangles = arrange(triangleNumbers, workers);
        int[] planeNumbers = kinds.planes.toArray();
        Plane[] allPlanes = new Plane[planeNumbers.length];
        Triangle[] allTriangles = new Triangle[triangleNumbers.length];
        fill(planeNumbers, allPlanes, workers);
        fill(triangleNumbers, allTriangles, workers);
        Sphere[] allSpheres = new Sphere[sphereNumbers.length];
        Box[] allBoxes = new Box[boxNumbers.length];
        double[] packedSpheres = list(sphereNumbers, allSpheres, workers);
        double[] packedBoxes = list(boxNumbers, allBoxes, workers);
        planes = new PlaneList(allPlanes, planeNumbers, group(allPlanes, planeNumbers));
        spheres = new SphereList(allSpheres, packedSpheres, sphereNumbers, overSpheres);
        boxes = new BoxList(allBoxes, packedBoxes, boxNumbers, overBoxes);
        triangles = new TriangleList(allTriangles, triangleNumbers, overTriangles);
        lists = hasTriangles() ? new SurfaceList[] {planes, spheres, boxes, triangles}
            : new SurfaceList[] {planes, spheres, boxes};
        hasHierarchy = overSpheres.isPresent() || overBoxes.isPresent() || overTriangles.isPresent();
        checkThatAllAreListed();
        transmittances = new double[surfaces.length];
        if (shadowMode == ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT) {
            setTransmittances(scene.materials(), workers);
        }
    }

    private void setTransmittances(List<Material> materials, ForkJoin workers) {
        double[] ofMaterials = new double[materials.size()];
        for (int i = 0; i < ofMaterials.length; i++) {
            ofMaterials[i] = materials.get(i).transparency();
        }
        workers.runRanges(transmittances.length, new ForkJoin.Range() {
            @Override
            public void run(int from, int to) {
                for (int i = from; i < to; i++) {
                    transmittances[i] = ofMaterials[surfaces[i].material()];
                }
            }
        });
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

    private long countInHierarchy(int[] numbers) {
        return needsHierarchy(numbers) ? numbers.length : 0;
    }

    private boolean needsHierarchy(int[] numbers) {
        return numbers.length >= FEWEST_IN_A_HIERARCHY && shortcuts.contains(Shortcut.HIERARCHY);
    }

    /** Groups many planes, and brings them and their numbers in the order of the groups. */
    private Optional<PlaneGroups> group(Plane[] planes, int[] numbers) {
        return planes.length >= FEWEST_IN_GROUPS && shortcuts.contains(Shortcut.HIERARCHY)
            ? Optional.of(PlaneGroups.of(planes, numbers)) : Optional.empty();
    }

    /** Builds a hierarchy over many bodies, and brings their numbers in its order. */
    private Optional<Hierarchy> arrange(int[] numbers, ForkJoin workers) {
        if (!needsHierarchy(numbers)) {
            return Optional.empty();
        }
        Bounds bounds = new Bounds(numbers.length);
        workers.runRanges(numbers.length, new ForkJoin.Range() {
            @Override
            public void run(int from, int to) {
                for (int i = from; i < to; i++) {
                    ((Bounded) surfaces[numbers[i]]).bound(bounds, i);
                }
            }
        });
        Hierarchy hierarchy = Hierarchy.over(bounds, workers);
        int[] order = hierarchy.order();
        int[] listed = numbers.clone();
        workers.runRanges(numbers.length, new ForkJoin.Range() {
            @Override
            public void run(int from, int to) {
                for (int i = from; i < to; i++) {
                    numbers[i] = listed[order[i]];
                }
            }
        });
        return Optional.of(hierarchy);
    }

    /** Fills a list with the bodies of these numbers, which are of its kind; returns what {@link Body#pack} writes of each. */
    private double[] list(int[] numbers, Body[] list, ForkJoin workers) {
        double[] packed = new double[Math.multiplyExact(Body.PACKED, numbers.length)];
        workers.runRanges(numbers.length, new ForkJoin.Range() {
            @Override
            public void run(int from, int to) {
                for (int i = from; i < to; i++) {
                    Body body = (Body) surfaces[numbers[i]];
                    list[i] = body;
                    body.pack(packed, Body.PACKED * i);
                }
            }
        });
        return packed;
    }

    /** Fills a list with the surfaces of these numbers, which are of its kind. */
    private void fill(int[] numbers, Surface[] list, ForkJoin workers) {
        workers.runRanges(numbers.length, new ForkJoin.Range() {
            @Override
            public void run(int from, int to) {
                for (int i = from; i < to; i++) {
                    list[i] = surfaces[numbers[i]];
                }
            }
        });
    }

    /** Numbers of surfaces, one after the other. */
    private static final class Numbers {
        private int[] numbers = new int[16];
        private int count;

        boolean add(int number) {
            if (count == numbers.length) {
                numbers = Arrays.copyOf(numbers, 2 * count);
            }
            numbers[count++] = number;
            return true;
        }

        void addAll(Numbers others) {
            if (count + others.count > numbers.length) {
                numbers = Arrays.copyOf(numbers, count + others.count);
            }
            System.arraycopy(others.numbers, 0, numbers, count, others.count);
            count += others.count;
        }

        int[] toArray() {
            return Arrays.copyOf(numbers, count);
        }
    }

    /** Sorts the numbers of surfaces by kind. */
    private static final class Kinds implements Surface.Visitor<Boolean> {
        private final Numbers spheres = new Numbers();
        private final Numbers planes = new Numbers();
        private final Numbers boxes = new Numbers();
        private final Numbers triangles = new Numbers();
        private int number;

        /** Those of the surfaces with numbers from {@code from} to before {@code to}. */
        static Kinds of(Surface[] surfaces, int from, int to, ForkJoin workers) {
            Kinds kinds = new Kinds();
            if (to - from <= ForkJoin.LARGE_RANGE) {
                kinds.addAll(surfaces, from, to);
                return kinds;
            }
            int middle = (from + to) >>> 1;
            Kinds[] halves = new Kinds[2];
            workers.runBoth(() -> halves[0] = of(surfaces, from, middle, workers),
                () -> halves[1] = of(surfaces, middle, to, workers));
            halves[0].addAll(halves[1]);
            return halves[0];
        }

        private void addAll(Surface[] surfaces, int from, int to) {
            for (number = from; number < to; number++) {
                surfaces[number].accept(this);
            }
        }

        private void addAll(Kinds others) {
            spheres.addAll(others.spheres);
            planes.addAll(others.planes);
            boxes.addAll(others.boxes);
            triangles.addAll(others.triangles);
        }

        @Override
        public Boolean visit(Sphere sphere) {
            return spheres.add(number);
        }

        @Override
        public Boolean visit(Plane plane) {
            return planes.add(number);
        }

        @Override
        public Boolean visit(Box box) {
            return boxes.add(number);
        }

        @Override
        public Boolean visit(Triangle triangle) {
            return triangles.add(number);
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

    /**
     * The lists of all kinds, but for triangles if there are none: a fourth list costs each ray some time. Of three kinds the
     * virtual machine compiles none into the loops over this, which a small picture would wait for (DECISIONS).
     */
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

    public TriangleList triangles() {
        return triangles;
    }

    public boolean hasTriangles() {
        return triangles.numbers().length > 0;
    }

    /** Whether there are so many surfaces of a kind that a hierarchy finds them. */
    public boolean hasHierarchy() {
        return hasHierarchy;
    }

    /** The share of light that each surface lets through, by its number in the scene; in [0, 1]. */
    public double[] transmittances() {
        return transmittances;
    }

    /** Whether a segment from a hit crosses the surface that was hit, or its body. An endless plane does not hide its back. */
    public boolean isOwnSurfaceCrossed(Hit hit, Segment segment) {
        return (hit.side() == Departure.INWARD
            || hit.departureTowards(segment.dx(), segment.dy(), segment.dz()) == Departure.INWARD)
            && surfaces[hit.surface()] instanceof Bounded own && own.isCrossedFrom(hit, segment);
    }
}
