package raytracing.scene;

import raytracing.math.Basis;
import raytracing.math.Vector;

/**
 * The scene line {@code cam}.
 *
 * @param position where it stands, world axes
 * @param lookAt the point in the middle of its picture; not its position
 * @param up which way is up in the picture; any length but 0, not parallel to the view
 * @param screenDistance from the position to the screen, above 0
 * @param screenWidth width of the screen, above 0; its height follows the picture's shape
 * @param lens pinhole or fisheye
 */
public record Camera(Vector position, Vector lookAt, Vector up,
                     double screenDistance, double screenWidth, Lens lens) {
    /** Halving both points first keeps their difference finite; no digit is lost where the difference overflows. */
    private static final double HALF = 0.5;

    /**
     * Where the camera looks.
     *
     * @return unit vector from the position to the look-at point
     * @throws ArithmeticException if the two are the same point
     */
    public Vector forward() {
        Vector view = lookAt.minus(position);
        return view.length() < Double.POSITIVE_INFINITY
            ? view.unit() : lookAt.times(HALF).minus(position.times(HALF)).unit();
    }

    /**
     * The axes of the picture. Right is up x forward, so x grows to the right for a camera that looks along +z with
     * +y up, as the exercise's pictures have it.
     *
     * @return u to the right, v up, w forward
     * @throws ArithmeticException if up is zero or parallel to the view, or there is no view
     */
    public Basis basis() {
        return Basis.looking(forward(), up.unit());
    }
}
