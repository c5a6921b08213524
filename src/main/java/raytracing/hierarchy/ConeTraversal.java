package raytracing.hierarchy;

/**
 * Finds the leaves of a hierarchy that reach into a cone of directions from a point, no further than a given distance.
 *
 * <p>The cone lies on one side of every plane that touches it along a line of its mantle. A box is outside if it lies
 * wholly on the other side of the plane that faces the box's middle. Boxes near the cone's tip may be kept without need,
 * none is left out wrongly.
 */
public final class ConeTraversal extends RegionTraversal {
    /** Of the sizes that go into a distance from a plane, how much it may be off: 24 roundings at most. */
    private static final double ROUNDING = 0x1p-46;

    private double apexX;
    private double apexY;
    private double apexZ;
    private double axisX;
    private double axisY;
    private double axisZ;
    private double sine;
    private double cosine;
    private double margin;
    private double latest;

    /**
     * Starts a query for the points apex + t d, t from 0 to {@code latest}, with unit vectors d at most a given angle off a
     * unit axis.
     *
     * @param sine of that angle, which is below a right angle
     * @param margin how far off all coordinates may be; boxes count as so much larger in every direction
     */
    public void startCone(Hierarchy hierarchy, double px, double py, double pz, double ax, double ay, double az,
                          double sine, double cosine, double margin, double latest) {
        start(hierarchy);
        apexX = px;
        apexY = py;
        apexZ = pz;
        axisX = ax;
        axisY = ay;
        axisZ = az;
        this.sine = sine;
        this.cosine = cosine;
        this.margin = margin;
        this.latest = latest;
    }

    /** Leaves beyond this distance from the apex no longer matter. */
    public void endAt(double distance) {
        latest = distance;
    }

    /** Every comparison is such that NaN leaves no box outside. */
    @Override
    boolean isOutside(int box) {
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
        double slack = ROUNDING * (Math.abs(x) + Math.abs(y) + Math.abs(z) + halfX + halfY + halfZ);
        double along = x * axisX + y * axisY + z * axisZ;
        return along - reach(axisX, axisY, axisZ, halfX, halfY, halfZ) > latest + slack + ROUNDING * latest
            || isBeside(x, y, z, along, halfX, halfY, halfZ, slack);
    }

    private boolean isBeside(double x, double y, double z, double along, double halfX, double halfY, double halfZ,
                             double slack) {
        double asideX = x - along * axisX;
        double asideY = y - along * axisY;
        double asideZ = z - along * axisZ;
        // what rounding left of the axis is taken away, too: else a box near the axis would get a plane askew
        double rest = asideX * axisX + asideY * axisY + asideZ * axisZ;
        asideX -= rest * axisX;
        asideY -= rest * axisY;
        asideZ -= rest * axisZ;
        double part = cosine / Math.sqrt(asideX * asideX + asideY * asideY + asideZ * asideZ);
        double nx = part * asideX - sine * axisX;
        double ny = part * asideY - sine * axisY;
        double nz = part * asideZ - sine * axisZ;
        return x * nx + y * ny + z * nz - reach(nx, ny, nz, halfX, halfY, halfZ) > slack;
    }

    private static double reach(double nx, double ny, double nz, double halfX, double halfY, double halfZ) {
        return halfX * Math.abs(nx) + halfY * Math.abs(ny) + halfZ * Math.abs(nz);
    }
}
