package raytracing.geometry;

import raytracing.math.Vector;

/**
 * The open straight line between two points.
 *
 * @param start one end, world axes
 * @param startError how far each part of it may be off
 * @param end the other end
 * @param endError how far each part of it may be off
 */
public record Segment(Vector start, double startError, Vector end, double endError) {
}
