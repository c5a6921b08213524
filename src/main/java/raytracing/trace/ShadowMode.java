package raytracing.trace;

/** What a transparent surface does to the light that falls through it. */
public enum ShadowMode {
    /** It lets through the share that its transparency names. */
    TRANSPARENT_SURFACES_PASS_LIGHT,

    /** It stops all light, like any other surface: the way of the exercise without its bonus. */
    ALL_SURFACES_STOP_LIGHT
}
