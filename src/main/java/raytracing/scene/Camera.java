package raytracing.scene;

import raytracing.math.Vector;

/**
 * The scene line {@code cam}.
 *
 * @param lookAt the point in the middle of the picture; not the position
 * @param up direction that is up in the picture; any length but 0, not parallel to the view
 * @param screenDistance from the position to the screen, above 0
 * @param screenWidth above 0; the screen's height follows from the picture's shape
 */
public record Camera(Vector position, Vector lookAt, Vector up, double screenDistance, double screenWidth, Lens lens) {
    /** The unit vector from the position to the look-at point; throws {@link ArithmeticException} if they are the same. */
    public Vector forward() {
        Vector view = lookAt.minus(position);
        // where the difference overflows, that of halves is finite and loses no digit
        return view.length() < Double.POSITIVE_INFINITY ? view.unit() : lookAt.times(0.5).minus(position.times(0.5)).unit();
    }

    /**
     * The unit vector to the right in the picture: up x forward, so x grows to the right for a camera that looks along +z with
     * +y up, as in the exercise's pictures.
     *
     * @throws ArithmeticException if up is zero or parallel to the view, or there is no view
     */
    public Vector right() {
        return up.unit().cross(forward()).unit();
    }
}
