package raytracing.outline;

/**
 * How the rays of a cone meet one surface: none of them, some, or all in the same part of it, and how far away. The tests of
 * surfaces write it. Not thread-safe.
 */
final class Sight {
    /**
     * 512 u, with u = 2^-53: of the sizes that go into it, how much a length or a product of unit vectors here may be off
     * (proved: at most 40 roundings). It is also far above the error within which a hit counts as being on a box's edge, 16 u
     * of the way from the world's origin to the hit.
     */
    static final double ROUNDING = 0x1p-44;

    /** Of lengths in this range, squares and products of squares are normal numbers. */
    static final double SHORT = 0x1p-200;
    static final double LONG = 0x1p200;

    /** What the rays of a cone have in common. */
    enum Cover {
        /** No ray meets the surface. */
        NONE,

        /** Nothing is known of which rays meet it. */
        SOME,

        /** All rays meet it; if it is a box, on the same face. */
        ALL
    }

    Cover cover = Cover.NONE;

    /**
     * No ray meets the surface at a smaller distance than {@code from}, and if all do, none at a greater one than {@code
     * to}.
     */
    double from;
    double to;

    /**
     * For flat surfaces: a vector p such that a ray with direction d, of length 1, meets the surface at 1 / (p . d), or, if
     * it is met by some rays, there or later; and how far p may be off. Zero and infinite if nothing is known.
     */
    double px;
    double py;
    double pz;
    double flatError;

    /** Nothing known. */
    void setUnknown() {
        set(Cover.SOME, 0, Double.POSITIVE_INFINITY);
    }

    void set(Cover covered, double nearest, double furthest) {
        cover = covered;
        from = nearest;
        to = furthest;
        flatError = Double.POSITIVE_INFINITY;
        px = 0;
        py = 0;
        pz = 0;
    }

    void setFlat(double x, double y, double z, double error) {
        px = x;
        py = y;
        pz = z;
        flatError = error;
    }
}
