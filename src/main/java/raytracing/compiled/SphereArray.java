package raytracing.compiled;

import java.util.Optional;
import raytracing.geometry.Sphere;
import raytracing.geometry.SphereKernel;
import raytracing.math.Vector;

/** All spheres of a scene, flat. Entry i of every array belongs to the same sphere. */
final class SphereArray extends BodyArray {
    private final double[] x;
    private final double[] y;
    private final double[] z;
    private final double[] radius;
    private final int[] number;

    /** In the order of the hierarchy, if there is one: so each of its leaves is a row of entries. */
    SphereArray(Sphere[] spheres, int[] numbers, Optional<Hierarchy> hierarchy) {
        super(spheres.length, hierarchy);
        int count = spheres.length;
        x = new double[count];
        y = new double[count];
        z = new double[count];
        radius = new double[count];
        number = new int[count];
        for (int i = 0; i < count; i++) {
            int listed = listed(hierarchy, i);
            Sphere sphere = spheres[listed];
            x[i] = sphere.centre().x();
            y[i] = sphere.centre().y();
            z[i] = sphere.centre().z();
            radius[i] = sphere.radius();
            number[i] = numbers[listed];
        }
    }

    /** Boxes around spheres. */
    static Bounds bounds(Sphere[] spheres) {
        Bounds bounds = new Bounds(spheres.length);
        for (int i = 0; i < spheres.length; i++) {
            Vector centre = spheres[i].centre();
            bounds.setAround(i, centre.x(), centre.y(), centre.z(), spheres[i].radius());
        }
        return bounds;
    }

    @Override
    int lastOpaque(ShadowLine line) {
        return line.lastSphere;
    }

    @Override
    void offerCrossings(RayWalk ray, int from, int to, Crossings crossings) {
        double ox = ray.ox;
        double oy = ray.oy;
        double oz = ray.oz;
        double dx = ray.dx;
        double dy = ray.dy;
        double dz = ray.dz;
        double error = ray.originError;
        int left = ray.surfaceLeft;
        // as the loop calls methods, the virtual machine would read fields again for each sphere
        double[] cx = x;
        double[] cy = y;
        double[] cz = z;
        double[] r = radius;
        int[] numbers = number;
        for (int i = from; i < to; i++) {
            if (numbers[i] != left
                    && !SphereKernel.isPlainlyMissed(ox, oy, oz, dx, dy, dz, error, cx[i], cy[i], cz[i], r[i])) {
                crossings.offer(SphereKernel.firstCrossing(ox, oy, oz, dx, dy, dz, error, cx[i], cy[i], cz[i], r[i]),
                    numbers[i]);
            }
        }
    }

    @Override
    void addCrossed(ShadowLine line, int from, int to) {
        double px = line.px;
        double py = line.py;
        double pz = line.pz;
        double dx = line.dx;
        double dy = line.dy;
        double dz = line.dz;
        double error = Math.max(line.pointError, line.endError);
        for (int i = from; i < to && !line.crossed.isDark(); i++) {
            if (number[i] != line.surfaceLeft
                    && !SphereKernel.isPlainlyMissed(px, py, pz, dx, dy, dz, error,
                    x[i], y[i], z[i], radius[i])
                    && line.isCrossing(SphereKernel.crossesBetween(px, py, pz, line.pointError,
                    line.qx, line.qy, line.qz, line.endError, x[i], y[i], z[i], radius[i]), number[i])) {
                line.crossed.add(number[i]);
                line.lastSphere = line.crossed.isDark() ? i : line.lastSphere;
            }
        }
    }

    @Override
    void addTouched(ShadowShaft shaft, int from, int to) {
        double px = shaft.px;
        double py = shaft.py;
        double pz = shaft.pz;
        double nx = shaft.nx;
        double ny = shaft.ny;
        double nz = shaft.nz;
        double depth = shaft.depth;
        double halfWidth = shaft.halfWidth;
        for (int i = from; i < to && !shaft.certain.isDark(); i++) {
            double fx = x[i] - px;
            double fy = y[i] - py;
            double fz = z[i] - pz;
            double mz = fx * nx + fy * ny + fz * nz;
            double size = Math.abs(fx) + Math.abs(fy) + Math.abs(fz) + radius[i];
            double slack = shaft.margin + ShadowShaft.ROUNDING * size;
            double grown = radius[i] + slack;
            if (mz + grown < 0 || mz - grown > depth || number[i] == shaft.surfaceLeft) {
                continue;                    // before or behind the shaft
            }
            double mx = fx * shaft.ux + fy * shaft.uy + fz * shaft.uz;
            double my = fx * shaft.vx + fy * shaft.vy + fz * shaft.vz;
            double wall = halfWidth * mz + grown * shaft.slant;
            if (Math.abs(mx) * depth <= wall && Math.abs(my) * depth <= wall) {
                shaft.spheres.consider(shaft, number[i], i, mx, my, mz, radius[i], slack);
            }
        }
    }

    double radius(int i) {
        return radius[i];
    }

    /** Whether the line of a shaft to (endX, endY, endZ) crosses a sphere. */
    boolean isCrossed(ShadowShaft shaft, int i) {
        return shaft.isCrossing(SphereKernel.crossesBetween(shaft.px, shaft.py, shaft.pz, shaft.pointError,
            shaft.endX(), shaft.endY(), shaft.endZ(), shaft.endError, x[i], y[i], z[i], radius[i]), number[i]);
    }
}
