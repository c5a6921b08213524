package raytracing.area;

/** How a polygon lies to a half-plane. */
public enum Side {
    /** All of it is in the half-plane. */
    WITHIN,

    /** None of it is, but for its border. */
    BEYOND,

    /** Some of it is. */
    CUT;

    /** How it lies to the other half of the plane. */
    Side opposite() {
        return switch (this) {
            case WITHIN -> BEYOND;
            case BEYOND -> WITHIN;
            case CUT -> CUT;
        };
    }
}
