package raytracing.compiled;

import java.util.List;
import raytracing.geometry.Box;
import raytracing.geometry.BoxKernel;
import raytracing.geometry.Ray;

/** All boxes of a scene, flat. Entry i of every array belongs to the same box. */
final class BoxArray {
    private final double[] x;
    private final double[] y;
    private final double[] z;
    private final double[] half;
    private final int[] number;

    BoxArray(List<Box> boxes, List<Integer> numbers) {
        x = boxes.stream().mapToDouble(box -> box.centre().x()).toArray();
        y = boxes.stream().mapToDouble(box -> box.centre().y()).toArray();
        z = boxes.stream().mapToDouble(box -> box.centre().z()).toArray();
        half = boxes.stream().mapToDouble(box -> box.edge() / 2).toArray();
        number = numbers.stream().mapToInt(Integer::intValue).toArray();
    }

    /** Offers the first crossing of a ray with every box but the one it leaves. */
    void offerCrossings(Ray ray, Nearest nearest) {
        double ox = ray.origin().x();
        double oy = ray.origin().y();
        double oz = ray.origin().z();
        double dx = ray.direction().x();
        double dy = ray.direction().y();
        double dz = ray.direction().z();
        double originError = ray.originError();
        int left = ray.surfaceLeft();
        for (int i = 0; i < number.length; i++) {
            if (number[i] != left && !BoxKernel.isPlainlyMissed(ox, oy, oz, dx, dy, dz, nearest.distance(), originError,
                    x[i], y[i], z[i], half[i])) {
                nearest.offer(BoxKernel.firstCrossing(ox, oy, oz, dx, dy, dz, originError, x[i], y[i], z[i], half[i]),
                    number[i]);
            }
        }
    }

    /**
     * What the boxes let through of light between the points p and q, but for the surface left at p. The
     * array gives the transmittance of every surface of the scene by its number.
     */
    double transmittance(double px, double py, double pz, double pointError,
                         double qx, double qy, double qz, double endError,
                         int surfaceLeft, double[] transmittanceOf) {
        double dx = qx - px;
        double dy = qy - py;
        double dz = qz - pz;
        double error = Math.max(pointError, endError);
        double product = 1;
        for (int i = 0; i < number.length && product > 0; i++) {
            if (number[i] != surfaceLeft
                    && !BoxKernel.isPlainlyMissed(px, py, pz, dx, dy, dz, 1, error, x[i], y[i], z[i], half[i])
                    && BoxKernel.crossesBetween(px, py, pz, pointError, qx, qy, qz, endError,
                    x[i], y[i], z[i], half[i])) {
                product *= transmittanceOf[number[i]];
            }
        }
        return product;
    }
}
