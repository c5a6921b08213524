package raytracing.color;

/**
 * Linear light that is being summed, or a factor on light: a {@link Color} that changes, so that shading does not allocate.
 * It is black at first. All that is read is finite, as in a Color. Not thread-safe.
 */
public final class MutableColor {
    private double red;
    private double green;
    private double blue;

    /** Becomes black. */
    public void clear() {
        set(0, 0, 0);
    }

    /** Each channel at least 0, may be infinite. */
    public void set(double newRed, double newGreen, double newBlue) {
        red = newRed;
        green = newGreen;
        blue = newBlue;
    }

    public void set(MutableColor other) {
        set(other.red, other.green, other.blue);
    }

    /** Becomes weight * filter, channel by channel. */
    public void setProduct(MutableColor weight, Color filter) {
        set(weight.red() * filter.red(), weight.green() * filter.green(), weight.blue() * filter.blue());
    }

    /** Multiplies by a factor, at least 0 and finite. */
    public void scale(double factor) {
        set(factor * red(), factor * green(), factor * blue());
    }

    /** Adds light, each channel at least 0. */
    public void add(double redLight, double greenLight, double blueLight) {
        red += redLight;
        green += greenLight;
        blue += blueLight;
    }

    /** Adds share * weight * light, channel by channel; share at least 0 and finite. */
    public void add(double share, Color weight, Color light) {
        red += product(share, weight.red(), light.red());
        green += product(share, weight.green(), light.green());
        blue += product(share, weight.blue(), light.blue());
    }

    /** As {@link #add(double, Color, Color)}. */
    public void add(double share, Color weight, MutableColor light) {
        red += product(share, weight.red(), light.red());
        green += product(share, weight.green(), light.green());
        blue += product(share, weight.blue(), light.blue());
    }

    /** As {@link #add(double, Color, Color)}. */
    public void add(double share, MutableColor weight, Color light) {
        red += product(share, weight.red(), light.red());
        green += product(share, weight.green(), light.green());
        blue += product(share, weight.blue(), light.blue());
    }

    /** As {@link #add(double, Color, Color)}. */
    public void add(double share, MutableColor weight, MutableColor light) {
        red += product(share, weight.red(), light.red());
        green += product(share, weight.green(), light.green());
        blue += product(share, weight.blue(), light.blue());
    }

    /** Never infinity times 0, which would be NaN. */
    private static double product(double share, double weight, double light) {
        return Math.min(share * weight, Double.MAX_VALUE) * light;
    }

    public double red() {
        return Math.min(red, Double.MAX_VALUE);
    }

    public double green() {
        return Math.min(green, Double.MAX_VALUE);
    }

    public double blue() {
        return Math.min(blue, Double.MAX_VALUE);
    }

    /** The largest channel. */
    public double max() {
        return Math.max(red(), Math.max(green(), blue()));
    }

    /** A copy that does not change. */
    public Color toColor() {
        return new Color(red, green, blue);
    }
}
