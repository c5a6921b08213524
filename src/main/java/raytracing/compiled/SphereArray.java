package raytracing.compiled;

import java.util.List;
import raytracing.geometry.Ray;
import raytracing.geometry.Sphere;
import raytracing.geometry.SphereKernel;
import raytracing.math.AxisOrder;

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

    /**
     * Offers the first crossing of a ray with every sphere but the one it leaves. Its origin o and direction d are given in
     * the order of axes that is the ray's.
     */
    void offerCrossings(Ray ray, AxisOrder order, double ou, double ov, double ow, double du, double dv, double dw,
                        Nearest nearest) {
        double[] u = order.first(x, y, z);
        double[] v = order.first(y, z, x);
        double[] w = order.first(z, x, y);
        double originError = ray.originError();
        int left = ray.surfaceLeft();
        for (int i = 0; i < number.length; i++) {
            if (number[i] != left
                    && !SphereKernel.isPlainlyMissed(ou, ov, ow, du, dv, dw, u[i], v[i], w[i], radius[i])) {
                nearest.offer(SphereKernel.firstCrossing(ou, ov, ow, du, dv, dw, originError,
                    u[i], v[i], w[i], radius[i]), number[i]);
            }
        }
    }

    /**
     * What the spheres let through of light between the points p and q, but for the surface left at p. The
     * array gives the transmittance of every surface of the scene by its number.
     */
    double transmittance(double px, double py, double pz, double pointError,
                         double qx, double qy, double qz, double endError,
                         int surfaceLeft, double[] transmittanceOf) {
        double dx = qx - px;
        double dy = qy - py;
        double dz = qz - pz;
        double product = 1;
        for (int i = 0; i < number.length && product > 0; i++) {
            if (number[i] != surfaceLeft
                    && !SphereKernel.isPlainlyMissed(px, py, pz, dx, dy, dz, x[i], y[i], z[i], radius[i])
                    && SphereKernel.crossesBetween(px, py, pz, pointError, qx, qy, qz, endError,
                    x[i], y[i], z[i], radius[i])) {
                product *= transmittanceOf[number[i]];
            }
        }
        return product;
    }
}
