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
        for (int i = 0; i < number.length; i++) {
            if (number[i] != ray.surfaceLeft()) {
                nearest.offer(firstCrossing(i, ox, oy, oz, dx, dy, dz), number[i]);
            }
        }
    }

    /**
     * What the boxes let through of light between o and o + d, both ends open, but for the surface left at o. The
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
        return BoxKernel.firstCrossing(ox - x[i], oy - y[i], oz - z[i], dx, dy, dz, half[i]);
    }
}
