package raytracing.compiled;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import raytracing.geometry.Box;
import raytracing.geometry.Departure;
import raytracing.geometry.Hit;
import raytracing.geometry.Plane;
import raytracing.geometry.Ray;
import raytracing.geometry.Sphere;
import raytracing.geometry.Surface;
import raytracing.math.Vector;
import raytracing.scene.Scene;

/**
 * The surfaces of a scene behind the two questions that shading asks: what does a ray meet next, and how much light
 * comes through between two points. One array for each kind keeps the calls in the loops to a single receiver, which
 * the virtual machine can inline; the kernels are those of the objects, so the answers are theirs, bit for bit.
 * Immutable.
 */
public final class CompiledScene {
    private final List<Surface> surfaces;
    private final SphereArray spheres;
    private final PlaneArray planes;
    private final BoxArray boxes;
    private final double[] transmittanceOf;

    /**
     * Sorts the surfaces of a scene by kind.
     *
     * @param scene the scene
     * @param shadowMode what transparent surfaces do to light that falls through them
     */
    public CompiledScene(Scene scene, ShadowMode shadowMode) {
        surfaces = scene.surfaces();
        Sorter sorter = new Sorter();
        for (Surface surface : surfaces) {
            surface.presentTo(sorter);
            sorter.number++;
        }
        spheres = new SphereArray(sorter.spheres, sorter.sphereNumbers);
        planes = new PlaneArray(sorter.planes, sorter.planeNumbers);
        boxes = new BoxArray(sorter.boxes, sorter.boxNumbers);
        transmittanceOf = new double[surfaces.size()];
        if (shadowMode == ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT) {
            for (int i = 0; i < transmittanceOf.length; i++) {
                transmittanceOf[i] = scene.materials().get(surfaces.get(i).material()).transparency();
            }
        }
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

    /**
     * What a ray meets first.
     *
     * @param ray any ray
     * @return the nearest crossing ahead, of equally near ones that of the surface listed first; none if the ray
     *         meets nothing
     */
    public Optional<Hit> firstHit(Ray ray) {
        return nearest(ray, new Nearest(0, Integer.MAX_VALUE));
    }

    /**
     * What a ray meets next after going straight through a surface. Every surface counts once along a ray, with its
     * first crossing; walking from hit to hit passes each of them once, coincident ones included.
     *
     * @param ray the ray that made {@code previous}
     * @param previous the hit to go on from
     * @return the next crossing in the same order, or none
     */
    public Optional<Hit> nextHit(Ray ray, Hit previous) {
        return nearest(ray, new Nearest(previous.distance(), previous.surface()));
    }

    private Optional<Hit> nearest(Ray ray, Nearest nearest) {
        spheres.offerCrossings(ray, nearest);
        planes.offerCrossings(ray, nearest);
        boxes.offerCrossings(ray, nearest);
        int left = ray.surfaceLeft();
        if (left != Ray.NO_SURFACE) {
            nearest.offer(surfaces.get(left).firstCrossing(ray.origin(), ray.direction(), ray.departure()), left);
        }
        if (nearest.isMiss()) {
            return Optional.empty();
        }
        int surface = nearest.surface();
        return Optional.of(surfaces.get(surface).hit(ray, nearest.distance(), surface));
    }

    /**
     * How much light comes through between a hit and a point off it. Every surface that the open line between them
     * meets counts once. The hit's own surface counts where the line goes through its body from wall to wall: so a
     * body shadows the part of a wide light that has sunk below the horizon of the hit.
     *
     * @param hit one end
     * @param dx the other end minus {@code hit.point()}, x part
     * @param dy y part
     * @param dz z part
     * @return product of the surfaces' transmittances, in [0, 1]
     */
    public double transmittance(Hit hit, double dx, double dy, double dz) {
        double ox = hit.point().x();
        double oy = hit.point().y();
        double oz = hit.point().z();
        int left = hit.surface();
        double product = spheres.transmittance(ox, oy, oz, dx, dy, dz, left, transmittanceOf);
        if (product > 0) {
            product *= planes.transmittance(ox, oy, oz, dx, dy, dz, left, transmittanceOf);
        }
        if (product > 0) {
            product *= boxes.transmittance(ox, oy, oz, dx, dy, dz, left, transmittanceOf);
        }
        if (product > 0 && hit.departureTowards(dx, dy, dz) == Departure.INWARD) {
            product *= ownTransmittance(hit, new Vector(dx, dy, dz));
        }
        return product;
    }

    private double ownTransmittance(Hit hit, Vector inward) {
        boolean throughBody = surfaces.get(hit.surface()).firstCrossing(hit.point(), inward, Departure.INWARD) < 1;
        return throughBody ? transmittanceOf[hit.surface()] : 1;
    }
}
