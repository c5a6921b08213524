package raytracing.compiled;

import java.util.List;
import raytracing.geometry.Sphere;
import raytracing.geometry.SphereKernel;

/** All spheres of a scene, flat. Entry i of every array belongs to the same sphere. */
final class SphereArray {
    private final double[] x;
    private final double[] y;
    private final double[] z;
    private final double[] radius;
    private final int[] number;

    SphereArray(List<Sphere> spheres, int[] numbers) {
        int count = spheres.size();
        x = new double[count];
        y = new double[count];
        z = new double[count];
        radius = new double[count];
        number = numbers;
        for (int i = 0; i < count; i++) {
            Sphere sphere = spheres.get(i);
            x[i] = sphere.centre().x();
            y[i] = sphere.centre().y();
            z[i] = sphere.centre().z();
            radius[i] = sphere.radius();
        }
    }

    int count() {
        return number.length;
    }

    /** Number of a sphere in the scene. */
    int number(int i) {
        return number[i];
    }

    /** Offers the first crossing of a ray with every sphere from one entry up to another, but for the one it leaves. */
    void offerCrossings(RayWalk ray, int from, int to, Nearest nearest) {
        double[] u = ray.order.first(x, y, z);
        double[] v = ray.order.first(y, z, x);
        double[] w = ray.order.first(z, x, y);
        double ou = ray.ou;
        double ov = ray.ov;
        double ow = ray.ow;
        double du = ray.du;
        double dv = ray.dv;
        double dw = ray.dw;
        for (int i = from; i < to; i++) {
            if (number[i] != ray.surfaceLeft
                    && !SphereKernel.isPlainlyMissed(ou, ov, ow, du, dv, dw, u[i], v[i], w[i], radius[i])) {
                nearest.offer(SphereKernel.firstCrossing(ou, ov, ow, du, dv, dw, ray.originError,
                    u[i], v[i], w[i], radius[i]), number[i]);
            }
        }
    }

    /** Adds those spheres from one entry up to another that a line crosses, but for the one it leaves. */
    void addCrossed(ShadowLine line, int from, int to) {
        double px = line.px;
        double py = line.py;
        double pz = line.pz;
        double dx = line.dx;
        double dy = line.dy;
        double dz = line.dz;
        for (int i = from; i < to && !line.crossed.isDark(); i++) {
            if (number[i] != line.surfaceLeft
                    && !SphereKernel.isPlainlyMissed(px, py, pz, dx, dy, dz, x[i], y[i], z[i], radius[i])
                    && SphereKernel.crossesBetween(px, py, pz, line.pointError, line.qx, line.qy, line.qz, line.endError,
                    x[i], y[i], z[i], radius[i])) {
                line.crossed.add(number[i]);
            }
        }
    }

    /** Adds those spheres from one entry up to another that lines of a shaft may cross, but for the one they leave. */
    void addTouched(ShadowShaft shaft, int from, int to) {
        double px = shaft.px;
        double py = shaft.py;
        double pz = shaft.pz;
        double nx = shaft.nx;
        double ny = shaft.ny;
        double nz = shaft.nz;
        for (int i = from; i < to && !shaft.certain.isDark(); i++) {
            double fx = x[i] - px;
            double fy = y[i] - py;
            double fz = z[i] - pz;
            double along = fx * nx + fy * ny + fz * nz;
            double size = Math.abs(fx) + Math.abs(fy) + Math.abs(fz) + radius[i];
            double slack = shaft.margin + ShadowShaft.ROUNDING * size;
            double grown = radius[i] + slack;
            if (along + grown >= 0 && along - grown <= shaft.depth && number[i] != shaft.surfaceLeft) {
                shaft.spheres.consider(shaft, number[i], i, fx, fy, fz, along, radius[i], slack);
            }
        }
    }

    /** Whether the line of a shaft to (endX, endY, endZ) crosses a sphere. */
    boolean isCrossed(ShadowShaft shaft, int i) {
        return SphereKernel.crossesBetween(shaft.px, shaft.py, shaft.pz, shaft.pointError,
            shaft.endX(), shaft.endY(), shaft.endZ(), shaft.endError, x[i], y[i], z[i], radius[i]);
    }
}
