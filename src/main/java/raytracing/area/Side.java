package raytracing.area;

/** How much of a polygon is in a half-plane or another figure: all; nothing, but perhaps its border; or a part. */
enum Side {
    WITHIN, BEYOND, CUT
}
