package raytracing.compiled;

import java.util.Optional;

/**
 * Bodies of one kind, flat: asked one after the other, or, if there are many, in the order of a hierarchy whose leaves are
 * rows of entries. Two kinds at most extend this, as the virtual machine compiles no more into one call.
 */
abstract class BodyArray {
    final int count;
    final Optional<Hierarchy> hierarchy;

    BodyArray(int count, Optional<Hierarchy> hierarchy) {
        this.count = count;
        this.hierarchy = hierarchy;
    }

    /** Which of the bodies, as they were listed, comes at an entry. */
    static int listed(Optional<Hierarchy> hierarchy, int entry) {
        return hierarchy.isPresent() ? hierarchy.get().order()[entry] : entry;
    }

    boolean hasHierarchy() {
        return hierarchy.isPresent();
    }

    /** Offers the first crossing of a ray with every body, but for the one it leaves. */
    final void offerCrossings(RayWalk ray, HierarchyWalk walk, Crossings crossings) {
        if (hierarchy.isEmpty()) {
            if (count > 0) {
                offerCrossings(ray, 0, count, crossings);
            }
            return;
        }
        walk.startRay(hierarchy.get(), ray.ox, ray.oy, ray.oz, ray.originError, ray.dx, ray.dy, ray.dz);
        while (walk.nextLeaf(crossings.distance())) {
            offerCrossings(ray, walk.from(), walk.to(), crossings);
        }
    }

    /** Adds all bodies that a line crosses, but for the one it leaves; may stop when no light is left. */
    final void addCrossed(ShadowLine line, HierarchyWalk walk) {
        if (hierarchy.isEmpty()) {
            if (count > 0) {
                addCrossed(line, 0, count);
            }
            return;
        }
        int last = lastOpaque(line);
        if (last < count) {
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

    /** Adds all bodies that lines of a shaft may cross, but for the one they leave, while it is worth sorting. */
    final void addTouched(ShadowShaft shaft, PyramidWalk walk) {
        if (hierarchy.isEmpty()) {
            if (count > 0) {
                addTouched(shaft, 0, count);
            }
            return;
        }
        walk.startPyramid(hierarchy.get(), shaft.px, shaft.py, shaft.pz, shaft.nx, shaft.ny, shaft.nz,
            shaft.ux, shaft.uy, shaft.uz, shaft.vx, shaft.vy, shaft.vz, shaft.depth, shaft.halfWidth, shaft.margin);
        while (shaft.isWorthSorting() && walk.nextLeaf()) {
            addTouched(shaft, walk.from(), walk.to());
        }
    }

    /** Offers the first crossing of a ray with every body from one entry up to another, but for the one it leaves. */
    abstract void offerCrossings(RayWalk ray, int from, int to, Crossings crossings);

    /** Adds those bodies from one entry up to another that a line crosses, but for the one it leaves. */
    abstract void addCrossed(ShadowLine line, int from, int to);

    /** Adds those bodies from one entry up to another that lines of a shaft may cross, but for the one they leave. */
    abstract void addTouched(ShadowShaft shaft, int from, int to);

    /** Entry of the body that stopped this thread's light last; beyond all entries if none did. */
    abstract int lastOpaque(ShadowLine line);
}
