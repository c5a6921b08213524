package raytracing.compiled;

import java.util.Optional;
import raytracing.geometry.Box;
import raytracing.geometry.BoxKernel;
import raytracing.geometry.HitPoint;
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
                    crossings.latest(), ray.originError, x[i], y[i], z[i], half[i])) {
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
                    && line.isCrossing(BoxKernel.crossesBetween(line.px, line.py, line.pz, line.pointError,
                    line.qx, line.qy, line.qz, line.endError, x[i], y[i], z[i], half[i]), number[i])) {
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

    /**
     * Of some faces that meet in an edge or corner of a box, those in whose planes the boxes that touch it there have faces, too,
     * through which a ray comes in.
     *
     * @param faces a bit 1 &lt;&lt; axis for each, with axis 0 for x, 1 for y, 2 for z
     * @param point where the ray meets the edge
     * @return all of the faces if no such plane is shared
     */
    int sharedFaces(int faces, HitPoint point, double dx, double dy, double dz, HierarchyWalk walk) {
        if (hierarchy.isEmpty()) {
            return sharedFaces(faces, point, dx, dy, dz, 0, count);
        }
        int shared = faces;
        walk.startRay(hierarchy.get(), point.x(), point.y(), point.z(), point.error(), dx, dy, dz);
        while (walk.nextLeaf(0)) {
            shared = sharedFaces(shared, point, dx, dy, dz, walk.from(), walk.to());
        }
        return shared;
    }

    private int sharedFaces(int faces, HitPoint point, double dx, double dy, double dz, int from, int to) {
        int shared = faces;
        for (int i = from; i < to; i++) {
            int others = new Box(new Vector(x[i], y[i], z[i]), 2 * half[i], 0).facesEntered(point, dx, dy, dz);
            shared = (shared & others) == 0 ? shared : shared & others;
        }
        return shared;
    }

    /** Adds the shadow of a box on the square of a shaft. */
    void addShadow(ShadowShaft shaft, int i, BoxShadow shadow, double transmittance) {
        double fx = x[i] - shaft.px;
        double fy = y[i] - shaft.py;
        double fz = z[i] - shaft.pz;
        double size = Math.abs(fx) + Math.abs(fy) + Math.abs(fz) + half[i];
        shadow.add(shaft, number[i], fx, fy, fz, half[i], shaft.margin + ShadowShaft.ROUNDING * size, transmittance);
    }

    /** The same for a line that starts before a face across an axis, on its plane as far as is known, and not near its edges. */
    boolean isCrossedFromFace(ShadowShaft shaft, int i, int axis) {
        double inwards = switch (axis) {
            case 0 -> Math.copySign(1, x[i] - shaft.px) * (shaft.endX() - shaft.px);
            case 1 -> Math.copySign(1, y[i] - shaft.py) * (shaft.endY() - shaft.py);
            default -> Math.copySign(1, z[i] - shaft.pz) * (shaft.endZ() - shaft.pz);
        };
        return Math.abs(inwards) > shaft.margin ? inwards > 0 : isCrossed(shaft, i);
    }

    /** Whether the line of a shaft to (endX, endY, endZ) crosses a box. */
    boolean isCrossed(ShadowShaft shaft, int i) {
        double qx = shaft.endX();
        double qy = shaft.endY();
        double qz = shaft.endZ();
        double error = Math.max(shaft.pointError, shaft.endError);
        return !BoxKernel.isPlainlyMissed(shaft.px, shaft.py, shaft.pz, qx - shaft.px, qy - shaft.py, qz - shaft.pz,
            1, error, x[i], y[i], z[i], half[i])
            && shaft.isCrossing(BoxKernel.crossesBetween(shaft.px, shaft.py, shaft.pz, shaft.pointError, qx, qy, qz,
            shaft.endError, x[i], y[i], z[i], half[i]), number[i]);
    }
}
