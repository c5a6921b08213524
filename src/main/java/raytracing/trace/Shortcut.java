package raytracing.trace;

/** Work that is skipped because it cannot change a bit of the picture. Tests switch each shortcut off. */
public enum Shortcut {
    /** Many surfaces are found through a hierarchy of bounds, or planes through groups, instead of one by one. */
    HIERARCHY,

    /** Shadow rays are tested only against the surfaces that touch the shaft from the point to the light. */
    SHADOW_SHAFTS,

    /** Most tests inside a shaft are made in its own coordinates, which costs less than in the world's. */
    SHAFT_COORDINATES
}
