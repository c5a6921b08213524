package raytracing.render;

/**
 * What the first rays of a pixel and of the eight around it tell about that pixel; see {@link FirstRays#look}. Differences of
 * light are in steps of 1/255 of what is shown, the largest over the channels. Not thread-safe; used for pixel after pixel.
 */
final class Neighbourhood {
    /** Whether the pixel's own ray led to mirrored rays. */
    boolean isMirror;

    /** How far the pixel's own ray was from the edge of a sharp highlight, in radians; below 0 inside one. */
    double highlightMargin;

    /** Largest difference of light from all neighbours. */
    double contrast;

    /** The same from those neighbours alone whose rays themselves met the same surfaces. */
    double slope;

    /**
     * Largest second difference of light along a line of three pixels that see the same surfaces, 0 where light changes
     * evenly. Where only one neighbour of a line sees them, half the difference from it.
     */
    double bend;

    /** Whether some line of three does not see the same surfaces, so that how light changes there is not known. */
    boolean isAtOutline;

    /** Whether a neighbour that sees the same surfaces saw others in mirrors, or is in another part of a shadow. */
    boolean hasDetail;

    /** Largest difference of the highlight's margin from a neighbour that sees the same surfaces. */
    double highlightChange;

    /** Forgets all neighbours. */
    void begin(boolean isMirrorSeen, double ownHighlightMargin) {
        isMirror = isMirrorSeen;
        highlightMargin = ownHighlightMargin;
        contrast = 0;
        slope = 0;
        bend = 0;
        isAtOutline = false;
        hasDetail = false;
        highlightChange = 0;
    }
}
