package raytracing.surface;

import raytracing.hierarchy.Bounds;

/** A surface that ends somewhere, so that a box holds all of it. */
public sealed interface Bounded extends Surface permits Body, Triangle {
    /** Sets the i-th bounds to those of this surface. */
    void bound(Bounds bounds, int i);

    /**
     * Whether a segment that starts where this surface was hit crosses it: it ends behind a triangle, seen from where the hit
     * was seen, or outside a body, if it goes inwards.
     */
    boolean isCrossedFrom(Hit hit, Segment segment);
}
