package raytracing.shade;

import raytracing.color.Color;

/** Adds up light. One thread, sum after sum. */
public final class LightSum {
    private double red;
    private double green;
    private double blue;

    LightSum() {
    }

    void clear() {
        red = 0;
        green = 0;
        blue = 0;
    }

    /** Adds share * filter * light, channel by channel; share at least 0 and finite. */
    void add(double share, Color filter, Color light) {
        red += product(share, filter.red(), light.red());
        green += product(share, filter.green(), light.green());
        blue += product(share, filter.blue(), light.blue());
    }

    /** Adds share * filter * light, channel by channel; share at least 0 and finite. */
    void add(double share, Color filter, LightSum light) {
        red += product(share, filter.red(), light.red());
        green += product(share, filter.green(), light.green());
        blue += product(share, filter.blue(), light.blue());
    }

    /** Adds share * weight * light, channel by channel; share at least 0 and finite. */
    void add(double share, Weight weight, Color light) {
        red += product(share, weight.red(), light.red());
        green += product(share, weight.green(), light.green());
        blue += product(share, weight.blue(), light.blue());
    }

    /** Adds share * weight * light, channel by channel; share at least 0 and finite. */
    void add(double share, Weight weight, LightSum light) {
        red += product(share, weight.red(), light.red());
        green += product(share, weight.green(), light.green());
        blue += product(share, weight.blue(), light.blue());
    }

    /** Adds light channel by channel, each at least 0. */
    void add(double redLight, double greenLight, double blueLight) {
        red += redLight;
        green += greenLight;
        blue += blueLight;
    }

    /** Multiplies by a factor, at least 0 and finite. */
    void scale(double factor) {
        red = factor * red();
        green = factor * green();
        blue = factor * blue();
    }

    /** Never infinity times 0, which would be no number. */
    private static double product(double share, double weight, double light) {
        return Math.min(share * weight, Double.MAX_VALUE) * light;
    }

    /**
     * Linear light, finite.
     *
     * @return red part, at least 0
     */
    public double red() {
        return Math.min(red, Double.MAX_VALUE);
    }

    /**
     * Linear light, finite.
     *
     * @return green part, at least 0
     */
    public double green() {
        return Math.min(green, Double.MAX_VALUE);
    }

    /**
     * Linear light, finite.
     *
     * @return blue part, at least 0
     */
    public double blue() {
        return Math.min(blue, Double.MAX_VALUE);
    }

    /**
     * The sum as a value that stays.
     *
     * @return linear light
     */
    public Color total() {
        return new Color(red, green, blue);
    }
}
