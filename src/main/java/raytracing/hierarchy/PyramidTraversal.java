package raytracing.hierarchy;

/**
 * Finds the leaves of a hierarchy that reach into a pyramid: those that may hide some part of a square light from the
 * point at the pyramid's apex.
 *
 * <p>A box is outside a convex body if it lies wholly beyond the plane of one of its faces; that is so if its centre is
 * further beyond than the box reaches against the plane (Greene, Detecting Intersection of a Rectangular Solid and a
 * Convex Polyhedron, Graphics Gems IV, 1994). Boxes beyond an edge may be kept without need, none is left out wrongly.
 */
public final class PyramidTraversal extends RegionTraversal {
    /**
     * Of the sizes that go into a distance from a plane, how much it may be off: 16 roundings at most, and frames that
     * are a few parts in 2^53 from being square.
     */
    private static final double ROUNDING = 0x1p-46;

    /** Four sides, the base, and a plane through the apex along the base. */
    private static final int FACES = 6;

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

    /**
     * Starts a query for the pyramid whose apex is p, and whose base are the points p + length n + x u + y v with x and y
     * from -halfWidth to halfWidth; n, u and v are unit vectors at right angles.
     *
     * @param margin how far off all coordinates may be; boxes count as so much larger in every direction
     */
    public void startPyramid(Hierarchy hierarchy, double px, double py, double pz, double nx, double ny, double nz,
                             double ux, double uy, double uz, double vx, double vy, double vz,
                             double length, double halfWidth, double margin) {
        start(hierarchy);
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
    }

    /** Finds the box along the axes around apex and base, for a first test that costs six comparisons. */
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
     * Every comparison is such that NaN leaves no box outside. In one piece: the virtual machine does not compile a method of
     * more than 325 bytes into its callers again (DECISIONS).
     */
    @Override
    boolean isOutside(int box) {
        if (boxes[box] > highX || boxes[box + 1] > highY || boxes[box + 2] > highZ
                || boxes[box + 3] < lowX || boxes[box + 4] < lowY || boxes[box + 5] < lowZ) {
            return true;
        }
        double fromX = boxes[box] - apexX;
        double fromY = boxes[box + 1] - apexY;
        double fromZ = boxes[box + 2] - apexZ;
        double toX = boxes[box + 3] - apexX;
        double toY = boxes[box + 4] - apexY;
        double toZ = boxes[box + 5] - apexZ;
        double x = 0.5 * (fromX + toX);
        double y = 0.5 * (fromY + toY);
        double z = 0.5 * (fromZ + toZ);
        double halfX = 0.5 * (toX - fromX) + margin;
        double halfY = 0.5 * (toY - fromY) + margin;
        double halfZ = 0.5 * (toZ - fromZ) + margin;
        double slack = rounding * (Math.abs(x) + Math.abs(y) + Math.abs(z) + halfX + halfY + halfZ);
        for (int face = 0; face < FACES; face++) {
            double nx = normals[3 * face];
            double ny = normals[3 * face + 1];
            double nz = normals[3 * face + 2];
            double beyond = x * nx + y * ny + z * nz - offsets[face];
            if (beyond > halfX * Math.abs(nx) + halfY * Math.abs(ny) + halfZ * Math.abs(nz) + slack) {
                return true;
            }
        }
        return false;
    }
}
