package raytracing.compiled;

import java.util.Optional;
import raytracing.geometry.Box;
import raytracing.geometry.BoxKernel;
import raytracing.math.Vector;

/** All boxes of a scene, flat. Entry i of every array belongs to the same box. */
final class BoxArray extends BodyArray {
    private final double[] x;
    private final double[] y;
    private final double[] z;
    private final double[] half;
    private final int[] number;

    /** In the order of the hierarchy, if there is one: so each of its leaves is a row of entries. */
    BoxArray(Box[] boxes, int[] numbers, Optional<Hierarchy> hierarchy) {
        super(boxes.length, hierarchy);
        int count = boxes.length;
        x = new double[count];
        y = new double[count];
        z = new double[count];
        half = new double[count];
        number = new int[count];
        for (int i = 0; i < count; i++) {
            int listed = listed(hierarchy, i);
            Box box = boxes[listed];
            x[i] = box.centre().x();
            y[i] = box.centre().y();
            z[i] = box.centre().z();
            half[i] = box.edge() / 2;
            number[i] = numbers[listed];
        }
    }

    /** The boxes as those that a hierarchy is built of. */
    static Bounds bounds(Box[] boxes) {
        Bounds bounds = new Bounds(boxes.length);
        for (int i = 0; i < boxes.length; i++) {
            Vector centre = boxes[i].centre();
            bounds.setAround(i, centre.x(), centre.y(), centre.z(), boxes[i].edge() / 2);
        }
        return bounds;
    }

    @Override
    int lastOpaque(ShadowLine line) {
        return line.lastBox;
    }

    @Override
    void offerCrossings(RayWalk ray, int from, int to, Crossings crossings) {
        for (int i = from; i < to; i++) {
            if (number[i] != ray.surfaceLeft && !BoxKernel.isPlainlyMissed(ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz,
                    crossings.distance(), ray.originError, x[i], y[i], z[i], half[i])) {
                crossings.offer(BoxKernel.firstCrossing(ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz, ray.originError,
                    x[i], y[i], z[i], half[i]), number[i]);
            }
        }
    }

    @Override
    void addCrossed(ShadowLine line, int from, int to) {
        double error = Math.max(line.pointError, line.endError);
        for (int i = from; i < to && !line.crossed.isDark(); i++) {
            if (number[i] != line.surfaceLeft
                    && !BoxKernel.isPlainlyMissed(line.px, line.py, line.pz, line.dx, line.dy, line.dz, 1, error,
                    x[i], y[i], z[i], half[i])
                    && BoxKernel.crossesBetween(line.px, line.py, line.pz, line.pointError,
                    line.qx, line.qy, line.qz, line.endError, x[i], y[i], z[i], half[i])) {
                line.crossed.add(number[i]);
                line.lastBox = line.crossed.isDark() ? i : line.lastBox;
            }
        }
    }

    @Override
    void addTouched(ShadowShaft shaft, int from, int to) {
        for (int i = from; i < to && !shaft.certain.isDark(); i++) {
            if (number[i] != shaft.surfaceLeft) {
                shaft.boxes.consider(shaft, number[i], i, x[i] - shaft.px, y[i] - shaft.py, z[i] - shaft.pz, half[i]);
            }
        }
    }

    /** Adds the shadow of a box on the square of a shaft. */
    void addShadow(ShadowShaft shaft, int i, BoxShadow shadow, double transmittance) {
        double fx = x[i] - shaft.px;
        double fy = y[i] - shaft.py;
        double fz = z[i] - shaft.pz;
        double size = Math.abs(fx) + Math.abs(fy) + Math.abs(fz) + half[i];
        shadow.add(shaft, fx, fy, fz, half[i], shaft.margin + ShadowShaft.ROUNDING * size, transmittance);
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
