package raytracing.render;

/**
 * A rectangle of pixels that one thread draws.
 *
 * @param left first column
 * @param top first row
 * @param right column after the last
 * @param bottom row after the last
 */
record Tile(int left, int top, int right, int bottom) {
}
