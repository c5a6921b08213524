package raytracing.compiled;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import raytracing.geometry.Box;
import raytracing.geometry.Departure;
import raytracing.geometry.Hit;
import raytracing.geometry.Plane;
import raytracing.geometry.Ray;
import raytracing.geometry.Segment;
import raytracing.geometry.Sphere;
import raytracing.geometry.Surface;
import raytracing.math.AxisOrder;
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
        Vector o = ray.origin();
        Vector d = ray.direction();
        AxisOrder order = AxisOrder.of(d.x(), d.y(), d.z());
        double ou = order.first(o.x(), o.y(), o.z());
        double ov = order.first(o.y(), o.z(), o.x());
        double ow = order.first(o.z(), o.x(), o.y());
        double du = order.first(d.x(), d.y(), d.z());
        double dv = order.first(d.y(), d.z(), d.x());
        double dw = order.first(d.z(), d.x(), d.y());
        spheres.offerCrossings(ray, order, ou, ov, ow, du, dv, dw, nearest);
        planes.offerCrossings(ray, order, ou, ov, ow, du, dv, dw, nearest);
        boxes.offerCrossings(ray, nearest);
        int left = ray.surfaceLeft();
        if (left != Ray.NO_SURFACE) {
            nearest.offer(surfaces.get(left).firstCrossing(ray, ray.departure()), left);
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
     * @param qx the other end, x part
     * @param qy y part
     * @param qz z part
     * @param endError how far each part of the other end may be off
     * @return product of the surfaces' transmittances, in [0, 1]
     */
    public double transmittance(Hit hit, double qx, double qy, double qz, double endError) {
        double px = hit.point().x();
        double py = hit.point().y();
        double pz = hit.point().z();
        double error = hit.pointError();
        int left = hit.surface();
        double product = spheres.transmittance(px, py, pz, error, qx, qy, qz, endError, left, transmittanceOf);
        if (product > 0) {
            product *= planes.transmittance(px, py, pz, error, qx, qy, qz, endError, left, transmittanceOf);
        }
        if (product > 0) {
            product *= boxes.transmittance(px, py, pz, error, qx, qy, qz, endError, left, transmittanceOf);
        }
        if (product > 0 && hit.departureTowards(qx - px, qy - py, qz - pz) == Departure.INWARD) {
            product *= ownTransmittance(hit, new Segment(hit.point(), error, new Vector(qx, qy, qz), endError));
        }
        return product;
    }

    private double ownTransmittance(Hit hit, Segment inward) {
        return surfaces.get(hit.surface()).crosses(inward, Departure.INWARD) ? transmittanceOf[hit.surface()] : 1;
    }
}
