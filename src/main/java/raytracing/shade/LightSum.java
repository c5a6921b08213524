package raytracing.shade;

import raytracing.color.Color;

/** Adds up what reaches one pixel. One thread. */
final class LightSum {
    private double red;
    private double green;
    private double blue;

    /** Adds share * weight * light, channel by channel. */
    void add(double share, Color weight, Color light) {
        red += share * weight.red() * light.red();
        green += share * weight.green() * light.green();
        blue += share * weight.blue() * light.blue();
    }

    Color total() {
        return new Color(red, green, blue);
    }
}
