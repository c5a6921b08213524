package raytracing.surface;

import raytracing.math.Vector;

/** A surface that bounds a convex body. */
public sealed interface Body extends Bounded permits Sphere, Box {
    /** How many numbers tell where a body is and how large. */
    int PACKED = 4;

    /** Writes the coordinates of its middle and its size, {@link #PACKED} numbers in all, from an index on. */
    void pack(double[] numbers, int at);

    /**
     * Distance to the far wall, by doubles alone, for a ray that starts on the wall and goes inwards.
     *
     * @return above 0, or {@link #UNDECIDED}
     */
    double farWall(Ray ray);

    /** Whether a segment that starts on the wall and goes inwards ends strictly outside. */
    boolean isLeft(Segment segment);

    /** One that goes inwards crosses the body if it ends outside. */
    @Override
    default boolean isCrossedFrom(Hit hit, Segment segment) {
        return isLeft(segment);
    }

    /** Whether a ball of a radius of at least 0 is certainly outside. */
    boolean isApartFrom(double x, double y, double z, double radius);

    /** How deep a point is inside the body, rounded: 0 on the wall, below 0 outside. */
    double depth(Vector point);
}
