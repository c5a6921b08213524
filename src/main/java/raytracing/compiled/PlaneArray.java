package raytracing.compiled;

import java.util.List;
import raytracing.geometry.Plane;
import raytracing.geometry.PlaneKernel;
import raytracing.geometry.Ray;

/** All planes of a scene, flat. Entry i of every array belongs to the same plane. */
final class PlaneArray {
    private final double[] x;
    private final double[] y;
    private final double[] z;
    private final double[] offset;
    private final int[] number;

    PlaneArray(List<Plane> planes, List<Integer> numbers) {
        x = planes.stream().mapToDouble(plane -> plane.normal().x()).toArray();
        y = planes.stream().mapToDouble(plane -> plane.normal().y()).toArray();
        z = planes.stream().mapToDouble(plane -> plane.normal().z()).toArray();
        offset = planes.stream().mapToDouble(Plane::offset).toArray();
        number = numbers.stream().mapToInt(Integer::intValue).toArray();
    }

    /** Offers the first crossing of a ray with every plane but the one it leaves. */
    void offerCrossings(Ray ray, Nearest nearest) {
        double ox = ray.origin().x();
        double oy = ray.origin().y();
        double oz = ray.origin().z();
        double dx = ray.direction().x();
        double dy = ray.direction().y();
        double dz = ray.direction().z();
        for (int i = 0; i < number.length; i++) {
            if (number[i] != ray.surfaceLeft()) {
                nearest.offer(firstCrossing(i, ox, oy, oz, dx, dy, dz), number[i]);
            }
        }
    }

    /**
     * What the planes let through of light between o and o + d, both ends open, but for the surface left at o. The
     * array gives the transmittance of every surface of the scene by its number.
     */
    double transmittance(double ox, double oy, double oz, double dx, double dy, double dz,
                         int surfaceLeft, double[] transmittanceOf) {
        double product = 1;
        for (int i = 0; i < number.length && product > 0; i++) {
            if (number[i] != surfaceLeft && firstCrossing(i, ox, oy, oz, dx, dy, dz) < 1) {
                product *= transmittanceOf[number[i]];
            }
        }
        return product;
    }

    private double firstCrossing(int i, double ox, double oy, double oz, double dx, double dy, double dz) {
        return PlaneKernel.firstCrossing(x[i], y[i], z[i], offset[i], ox, oy, oz, dx, dy, dz);
    }
}
