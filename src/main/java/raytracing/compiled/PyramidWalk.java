package raytracing.compiled;

/**
 * Finds the leaves of a hierarchy that reach into a pyramid: those that may hide some part of a square light from the
 * point at the pyramid's apex. It belongs to one thread, serves query after query and makes no garbage.
 *
 * <p>A box is outside a convex body if it lies wholly beyond the plane of one of its faces; that is so if its centre is
 * further beyond than the box reaches against the plane (Greene, Detecting Intersection of a Rectangular Solid and a
 * Convex Polyhedron, Graphics Gems IV, 1994). Boxes beyond an edge may be kept without need, none is left out wrongly.
 */
final class PyramidWalk {
    /**
     * Of the sizes that go into a distance from a plane, how much it may be off: 16 roundings at most, and frames that
     * are a few parts in 2^53 from being square.
     */
    private static final double ROUNDING = 0x1p-46;

    /** Four sides, the base, and a plane through the apex along the base. */
    private static final int FACES = 6;

    private final int[] waiting = new int[Hierarchy.GREATEST_DEPTH + 1];
    private int waitingCount;

    private double[] boxes;
    private int[] links;
    private byte[] sizes;

    /** Three numbers for each face: no unit vectors, as the sides have length 1 across the axis. */
    private final double[] normals = new double[3 * FACES];

    /** How far each face's plane is from the apex, in units of its normal. */
    private final double[] offsets = new double[FACES];
    private double apexX;
    private double apexY;
    private double apexZ;
    private double lowX;
    private double lowY;
    private double lowZ;
    private double highX;
    private double highY;
    private double highZ;
    private double margin;
    private double rounding;

    private int from;
    private int to;

    /**
     * Begins to look through the pyramid whose apex is p, and whose base are the points p + length n + x u + y v with x
     * and y from -halfWidth to halfWidth.
     *
     * @param hierarchy over the bodies in question
     * @param px apex, x part
     * @param py y part
     * @param pz z part
     * @param nx unit vector along the axis, x part
     * @param ny y part
     * @param nz z part
     * @param ux unit vector across the axis, x part
     * @param uy y part
     * @param uz z part
     * @param vx unit vector across both, x part
     * @param vy y part
     * @param vz z part
     * @param length from the apex to the base
     * @param halfWidth half the edge of the base
     * @param margin how far off all coordinates may be; boxes count as so much larger in every direction
     */
    void startPyramid(Hierarchy hierarchy, double px, double py, double pz, double nx, double ny, double nz,
                      double ux, double uy, double uz, double vx, double vy, double vz,
                      double length, double halfWidth, double margin) {
        boxes = hierarchy.nodes().boxes();
        links = hierarchy.nodes().links();
        sizes = hierarchy.nodes().sizes();
        apexX = px;
        apexY = py;
        apexZ = pz;
        this.margin = margin;
        double grown = margin + ROUNDING * (Math.abs(px) + Math.abs(py) + Math.abs(pz) + 2 * (length + halfWidth));
        double slope = halfWidth / length;
        rounding = ROUNDING * (1 + slope);
        setNormal(0, ux - slope * nx, uy - slope * ny, uz - slope * nz);
        setNormal(1, -ux - slope * nx, -uy - slope * ny, -uz - slope * nz);
        setNormal(2, vx - slope * nx, vy - slope * ny, vz - slope * nz);
        setNormal(3, -vx - slope * nx, -vy - slope * ny, -vz - slope * nz);
        setNormal(4, -nx, -ny, -nz);
        setNormal(5, nx, ny, nz);
        offsets[5] = length;
        startAround(px + length * nx, py + length * ny, pz + length * nz,
            halfWidth * (Math.abs(ux) + Math.abs(vx)) + grown,
            halfWidth * (Math.abs(uy) + Math.abs(vy)) + grown,
            halfWidth * (Math.abs(uz) + Math.abs(vz)) + grown, grown);
        waiting[0] = Hierarchy.ROOT;
        waitingCount = 1;
    }

    /** Finds the box along the axes around apex and base, for a first question that costs six comparisons. */
    private void startAround(double baseX, double baseY, double baseZ, double halfX, double halfY, double halfZ,
                             double grown) {
        lowX = Math.min(apexX - grown, baseX - halfX);
        lowY = Math.min(apexY - grown, baseY - halfY);
        lowZ = Math.min(apexZ - grown, baseZ - halfZ);
        highX = Math.max(apexX + grown, baseX + halfX);
        highY = Math.max(apexY + grown, baseY + halfY);
        highZ = Math.max(apexZ + grown, baseZ + halfZ);
    }

    private void setNormal(int face, double x, double y, double z) {
        normals[3 * face] = x;
        normals[3 * face + 1] = y;
        normals[3 * face + 2] = z;
    }

    /**
     * Goes on to the next leaf.
     *
     * @return whether there is another leaf whose box may reach into the pyramid
     */
    boolean nextLeaf() {
        int count = waitingCount;
        while (count > 0) {
            count--;
            int node = waiting[count];
            if (!isOutside(node)) {
                int link = links[node];
                if (link < 0) {
                    from = ~link;
                    to = from + sizes[node];
                    waitingCount = count;
                    return true;
                }
                waiting[count] = link + 1;
                waiting[count + 1] = link;
                count += 2;
            }
        }
        waitingCount = 0;
        return false;
    }

    /** Every comparison is such that NaN leaves no box outside. */
    private boolean isOutside(int node) {
        int at = Bounds.STRIDE * node;
        return boxes[at] > highX || boxes[at + 1] > highY || boxes[at + 2] > highZ
            || boxes[at + 3] < lowX || boxes[at + 4] < lowY || boxes[at + 5] < lowZ || isBeyondAFace(at);
    }

    private boolean isBeyondAFace(int at) {
        double fromX = boxes[at] - apexX;
        double fromY = boxes[at + 1] - apexY;
        double fromZ = boxes[at + 2] - apexZ;
        double toX = boxes[at + 3] - apexX;
        double toY = boxes[at + 4] - apexY;
        double toZ = boxes[at + 5] - apexZ;
        double x = 0.5 * (fromX + toX);
        double y = 0.5 * (fromY + toY);
        double z = 0.5 * (fromZ + toZ);
        double halfX = 0.5 * (toX - fromX) + margin;
        double halfY = 0.5 * (toY - fromY) + margin;
        double halfZ = 0.5 * (toZ - fromZ) + margin;
        double slack = rounding * (Math.abs(x) + Math.abs(y) + Math.abs(z) + halfX + halfY + halfZ);
        for (int face = 0; face < FACES; face++) {
            if (beyond(face, x, y, z) > reach(face, halfX, halfY, halfZ) + slack) {
                return true;
            }
        }
        return false;
    }

    private double beyond(int face, double x, double y, double z) {
        int at = 3 * face;
        return x * normals[at] + y * normals[at + 1] + z * normals[at + 2] - offsets[face];
    }

    private double reach(int face, double halfX, double halfY, double halfZ) {
        int at = 3 * face;
        return halfX * Math.abs(normals[at]) + halfY * Math.abs(normals[at + 1]) + halfZ * Math.abs(normals[at + 2]);
    }

    /** The first position of the leaf. */
    int from() {
        return from;
    }

    /** The position after the leaf's last. */
    int to() {
        return to;
    }
}
