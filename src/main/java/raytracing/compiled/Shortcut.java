package raytracing.compiled;

/** Work that the compiled scene skips because it cannot change an answer by a single bit. Tests switch each one off. */
public enum Shortcut {
    /** Many surfaces are found through a hierarchy of bounds instead of one by one. */
    HIERARCHY,

    /** Shadow rays ask only the surfaces that touch the shaft from the point to the light. */
    SHADOW_SHAFTS,

    /** Most questions inside a shaft are answered in its own coordinates, which costs less than in the world's. */
    SHAFT_COORDINATES
}
