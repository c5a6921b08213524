package raytracing.compiled;

import raytracing.geometry.Plane;
import raytracing.geometry.PlaneKernel;

/** All planes of a scene, flat. Entry i of every array belongs to the same plane. */
final class PlaneArray {
    private final double[] x;
    private final double[] y;
    private final double[] z;
    private final double[] offset;
    private final int[] number;

    PlaneArray(Plane[] planes, int[] numbers) {
        int count = planes.length;
        x = new double[count];
        y = new double[count];
        z = new double[count];
        offset = new double[count];
        number = numbers;
        for (int i = 0; i < count; i++) {
            Plane plane = planes[i];
            x[i] = plane.normal().x();
            y[i] = plane.normal().y();
            z[i] = plane.normal().z();
            offset[i] = plane.offset();
        }
    }

    /** Offers the crossing of a ray with every plane but the one it leaves. */
    void offerCrossings(RayWalk ray, Crossings crossings) {
        // as the loop calls methods, the virtual machine would read fields again for each plane
        double[] nx = x;
        double[] ny = y;
        double[] nz = z;
        double[] c = offset;
        int[] numbers = number;
        for (int i = 0; i < numbers.length; i++) {
            if (numbers[i] != ray.surfaceLeft) {
                crossings.offer(PlaneKernel.firstCrossing(ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz, ray.originError,
                    nx[i], ny[i], nz[i], c[i]), numbers[i]);
            }
        }
    }

    /** Adds the planes that a line crosses, but for the one it leaves. */
    void addCrossed(ShadowLine line) {
        for (int i = 0; i < number.length && !line.crossed.isDark(); i++) {
            if (number[i] != line.surfaceLeft
                    && line.isCrossing(PlaneKernel.crossesBetween(line.px, line.py, line.pz, line.pointError,
                    line.qx, line.qy, line.qz, line.endError, x[i], y[i], z[i], offset[i]), number[i])) {
                line.crossed.add(number[i]);
            }
        }
    }

    /**
     * Adds the planes that lines of a shaft may cross, but for the one they leave. The gap between plane and light square
     * is linear in the square's coordinates, so its least and its greatest value are at corners.
     */
    void addTouched(ShadowShaft shaft) {
        for (int i = 0; i < number.length && !shaft.certain.isDark(); i++) {
            if (number[i] != shaft.surfaceLeft) {
                double gap = offset[i] - (x[i] * shaft.px + y[i] * shaft.py + z[i] * shaft.pz);
                double middleGap = offset[i] - (x[i] * shaft.lx + y[i] * shaft.ly + z[i] * shaft.lz);
                double alongU = x[i] * shaft.ux + y[i] * shaft.uy + z[i] * shaft.uz;
                double alongV = x[i] * shaft.vx + y[i] * shaft.vy + z[i] * shaft.vz;
                double size = Math.abs(x[i]) + Math.abs(y[i]) + Math.abs(z[i]);
                double doubt = size * (shaft.margin + ShadowShaft.ROUNDING * shaft.reach)
                    + ShadowShaft.ROUNDING * Math.abs(offset[i]);
                shaft.planes.consider(shaft, number[i], i, gap, middleGap, alongU, alongV, doubt);
            }
        }
    }

    /** Whether the line of a shaft to (endX, endY, endZ) crosses a plane. */
    boolean isCrossed(ShadowShaft shaft, int i) {
        return shaft.isCrossing(PlaneKernel.crossesBetween(shaft.px, shaft.py, shaft.pz, shaft.pointError,
            shaft.endX(), shaft.endY(), shaft.endZ(), shaft.endError, x[i], y[i], z[i], offset[i]), number[i]);
    }
}
