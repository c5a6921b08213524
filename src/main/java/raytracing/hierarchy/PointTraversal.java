package raytracing.hierarchy;

/** Finds the leaves of a hierarchy whose boxes hold a point. */
public final class PointTraversal extends RegionTraversal {
    private double x;
    private double y;
    private double z;

    /** Starts a query for a point, in the axes of the boxes. */
    public void start(Hierarchy hierarchy, double pointX, double pointY, double pointZ) {
        start(hierarchy);
        x = pointX;
        y = pointY;
        z = pointZ;
    }

    /** A point with a NaN is outside all boxes. */
    @Override
    boolean isOutside(int box) {
        return !(x >= boxes[box] && x <= boxes[box + 3] && y >= boxes[box + 1] && y <= boxes[box + 4]
            && z >= boxes[box + 2] && z <= boxes[box + 5]);
    }
}
