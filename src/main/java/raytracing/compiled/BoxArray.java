package raytracing.compiled;

import java.util.Optional;
import raytracing.geometry.Box;
import raytracing.geometry.BoxKernel;
import raytracing.math.Vector;

/** All boxes of a scene, flat. Entry i of every array belongs to the same box. */
final class BoxArray {
    private final double[] x;
    private final double[] y;
    private final double[] z;
    private final double[] half;
    private final int[] number;
    private final Optional<Hierarchy> hierarchy;

    /** In the order of the hierarchy, if there is one: so each of its leaves is a row of entries. */
    BoxArray(Box[] boxes, int[] numbers, Optional<Hierarchy> hierarchy) {
        int count = boxes.length;
        this.hierarchy = hierarchy;
        x = new double[count];
        y = new double[count];
        z = new double[count];
        half = new double[count];
        number = new int[count];
        for (int i = 0; i < count; i++) {
            int listed = hierarchy.isPresent() ? hierarchy.get().order()[i] : i;
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

    boolean hasHierarchy() {
        return hierarchy.isPresent();
    }

    /** Offers the first crossing of a ray with every box, but for the one it leaves. */
    void offerCrossings(RayWalk ray, HierarchyWalk walk, Crossings crossings) {
        if (hierarchy.isEmpty()) {
            offerCrossings(ray, 0, number.length, crossings);
            return;
        }
        walk.startRay(hierarchy.get(), ray.ox, ray.oy, ray.oz, ray.originError, ray.dx, ray.dy, ray.dz);
        while (walk.nextLeaf(crossings.distance())) {
            offerCrossings(ray, walk.from(), walk.to(), crossings);
        }
    }

    /** Adds all boxes that a line crosses, but for the one it leaves; may stop when no light is left. */
    void addCrossed(ShadowLine line, HierarchyWalk walk) {
        if (hierarchy.isEmpty()) {
            addCrossed(line, 0, number.length);
            return;
        }
        int last = line.lastBox;
        if (last < number.length) {
            addCrossed(line, last, last + 1);
        }
        if (line.crossed.isDark()) {
            return;
        }
        walk.startRay(hierarchy.get(), line.px, line.py, line.pz, Math.max(line.pointError, line.endError),
            line.dx, line.dy, line.dz);
        while (!line.crossed.isDark() && walk.nextLeaf(1)) {
            addCrossed(line, walk.from(), walk.to());
        }
    }

    /** Adds all boxes that lines of a shaft may cross, but for the one they leave, while it is worth sorting. */
    void addTouched(ShadowShaft shaft, PyramidWalk walk) {
        if (hierarchy.isEmpty()) {
            addTouched(shaft, 0, number.length);
            return;
        }
        walk.startPyramid(hierarchy.get(), shaft.px, shaft.py, shaft.pz, shaft.nx, shaft.ny, shaft.nz,
            shaft.ux, shaft.uy, shaft.uz, shaft.vx, shaft.vy, shaft.vz, shaft.depth, shaft.halfWidth, shaft.margin);
        while (shaft.isWorthSorting() && walk.nextLeaf()) {
            addTouched(shaft, walk.from(), walk.to());
        }
    }

    /** Offers the first crossing of a ray with every box from one entry up to another, but for the one it leaves. */
    private void offerCrossings(RayWalk ray, int from, int to, Crossings crossings) {
        for (int i = from; i < to; i++) {
            if (number[i] != ray.surfaceLeft && !BoxKernel.isPlainlyMissed(ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz,
                    crossings.distance(), ray.originError, x[i], y[i], z[i], half[i])) {
                crossings.offer(BoxKernel.firstCrossing(ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz, ray.originError,
                    x[i], y[i], z[i], half[i]), number[i]);
            }
        }
    }

    /** Adds those boxes from one entry up to another that a line crosses, but for the one it leaves. */
    private void addCrossed(ShadowLine line, int from, int to) {
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

    /** Adds those boxes from one entry up to another that lines of a shaft may cross, but for the one they leave. */
    private void addTouched(ShadowShaft shaft, int from, int to) {
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
