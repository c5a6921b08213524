package raytracing.compiled;

import java.util.List;
import raytracing.geometry.Plane;
import raytracing.geometry.PlaneKernel;
import raytracing.geometry.Ray;
import raytracing.math.AxisOrder;

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

    /**
     * Offers the first crossing of a ray with every plane but the one it leaves. Its origin o and direction d are given in
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
            if (number[i] != left) {
                nearest.offer(PlaneKernel.firstCrossing(ou, ov, ow, du, dv, dw, originError,
                    u[i], v[i], w[i], offset[i]), number[i]);
            }
        }
    }

    /**
     * What the planes let through of light between the points p and q, but for the surface left at p. The
     * array gives the transmittance of every surface of the scene by its number.
     */
    double transmittance(double px, double py, double pz, double pointError,
                         double qx, double qy, double qz, double endError,
                         int surfaceLeft, double[] transmittanceOf) {
        double product = 1;
        for (int i = 0; i < number.length && product > 0; i++) {
            if (number[i] != surfaceLeft && PlaneKernel.crossesBetween(px, py, pz, pointError, qx, qy, qz, endError,
                    x[i], y[i], z[i], offset[i])) {
                product *= transmittanceOf[number[i]];
            }
        }
        return product;
    }
}
