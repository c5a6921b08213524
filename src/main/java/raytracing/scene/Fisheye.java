package raytracing.scene;

/**
 * A lens with a wider view the lower its k: with f the screen distance, light that arrives at an angle theta to
 * the view meets the screen at the radius R = f tan(k theta) / k for k above 0, f theta for k = 0 and
 * f sin(k theta) / k for k below 0. The exercise takes this family from PanoTools (its wiki, Fisheye Projection);
 * some members have names: k = 1 pinhole, 1/2 stereographic, 0 equidistant, -1/2 equisolid, -1 orthographic.
 *
 * @param k in [-1, 1]
 */
public record Fisheye(double k) implements Lens {
    /** Below this, x and its tangent or sine agree to the last bit: the next term is x^3 / 3, under 2^-55 of x. */
    private static final double SAME_AS_ITS_TANGENT = 0x1p-27;

    /**
     * The angle to the view, in radians and at least 0, of the light that arrives at a point of the screen: the relation
     * above, solved for theta. It may be beyond a right angle; it is NaN if no light arrives there from any angle, which
     * happens for k below 0 outside the circle |k| radius = 1.
     *
     * @param radius distance from the middle of the screen divided by the screen distance, at least 0
     */
    public double incidentAngle(double radius) {
        double x = k * radius;
        if (Math.abs(x) < SAME_AS_ITS_TANGENT) {
            return radius;
        }
        return (k > 0 ? StrictMath.atan(x) : StrictMath.asin(x)) / k;
    }
}
