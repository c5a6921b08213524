package raytracing.compiled;

import java.util.List;
import raytracing.geometry.Sphere;
import raytracing.geometry.SphereKernel;
import raytracing.geometry.Ray;

/** All spheres of a scene, flat. Entry i of every array belongs to the same sphere. */
final class SphereArray {
    private final double[] x;
    private final double[] y;
    private final double[] z;
    private final double[] radius;
    private final int[] number;

    SphereArray(List<Sphere> spheres, List<Integer> numbers) {
        x = spheres.stream().mapToDouble(sphere -> sphere.centre().x()).toArray();
        y = spheres.stream().mapToDouble(sphere -> sphere.centre().y()).toArray();
        z = spheres.stream().mapToDouble(sphere -> sphere.centre().z()).toArray();
        radius = spheres.stream().mapToDouble(Sphere::radius).toArray();
        number = numbers.stream().mapToInt(Integer::intValue).toArray();
    }

    /** Offers the first crossing of a ray with every sphere but the one it leaves. */
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
     * What the spheres let through of light between o and o + d, both ends open, but for the surface left at o. The
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
        return SphereKernel.firstCrossing(ox - x[i], oy - y[i], oz - z[i], dx, dy, dz, radius[i]);
    }
}
