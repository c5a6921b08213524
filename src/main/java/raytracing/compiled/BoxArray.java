package raytracing.compiled;

import java.util.List;
import raytracing.geometry.Box;
import raytracing.geometry.BoxKernel;

/** All boxes of a scene, flat. Entry i of every array belongs to the same box. */
final class BoxArray {
    private final double[] x;
    private final double[] y;
    private final double[] z;
    private final double[] half;
    private final int[] number;

    BoxArray(List<Box> boxes, int[] numbers) {
        int count = boxes.size();
        x = new double[count];
        y = new double[count];
        z = new double[count];
        half = new double[count];
        number = numbers;
        for (int i = 0; i < count; i++) {
            Box box = boxes.get(i);
            x[i] = box.centre().x();
            y[i] = box.centre().y();
            z[i] = box.centre().z();
            half[i] = box.edge() / 2;
        }
    }

    int count() {
        return number.length;
    }

    /** Offers the first crossing of a ray with every box from one entry up to another, but for the one it leaves. */
    void offerCrossings(RayWalk ray, int from, int to, Nearest nearest) {
        for (int i = from; i < to; i++) {
            if (number[i] != ray.surfaceLeft && !BoxKernel.isPlainlyMissed(ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz,
                    nearest.distance(), ray.originError, x[i], y[i], z[i], half[i])) {
                nearest.offer(BoxKernel.firstCrossing(ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz, ray.originError,
                    x[i], y[i], z[i], half[i]), number[i]);
            }
        }
    }

    /** Adds those boxes from one entry up to another that a line crosses, but for the one it leaves. */
    void addCrossed(ShadowLine line, int from, int to) {
        double error = Math.max(line.pointError, line.endError);
        for (int i = from; i < to && !line.crossed.isDark(); i++) {
            if (number[i] != line.surfaceLeft
                    && !BoxKernel.isPlainlyMissed(line.px, line.py, line.pz, line.dx, line.dy, line.dz, 1, error,
                    x[i], y[i], z[i], half[i])
                    && BoxKernel.crossesBetween(line.px, line.py, line.pz, line.pointError,
                    line.qx, line.qy, line.qz, line.endError, x[i], y[i], z[i], half[i])) {
                line.crossed.add(number[i]);
            }
        }
    }

    /** Adds those boxes from one entry up to another that lines of a shaft may cross, but for the one they leave. */
    void addTouched(ShadowShaft shaft, int from, int to) {
        for (int i = from; i < to && !shaft.certain.isDark(); i++) {
            if (number[i] != shaft.surfaceLeft) {
                shaft.boxes.consider(shaft, number[i], i, x[i] - shaft.px, y[i] - shaft.py, z[i] - shaft.pz, half[i]);
            }
        }
    }

    /** Whether the line of a shaft to (endX, endY, endZ) crosses a box. */
    boolean isCrossed(ShadowShaft shaft, int i) {
        double qx = shaft.endX();
        double qy = shaft.endY();
        double qz = shaft.endZ();
        double error = Math.max(shaft.pointError, shaft.endError);
        return !BoxKernel.isPlainlyMissed(shaft.px, shaft.py, shaft.pz, qx - shaft.px, qy - shaft.py, qz - shaft.pz,
            1, error, x[i], y[i], z[i], half[i])
            && BoxKernel.crossesBetween(shaft.px, shaft.py, shaft.pz, shaft.pointError, qx, qy, qz, shaft.endError,
            x[i], y[i], z[i], half[i]);
    }
}
