package raytracing.shade;

import raytracing.color.Color;

/** Adds up what reaches one pixel. One thread. */
final class LightSum {
    private double red;
    private double green;
    private double blue;

    /** Adds share * weight * light, channel by channel; share at least 0 and finite. */
    void add(double share, Color weight, Color light) {
        red += product(share, weight.red(), light.red());
        green += product(share, weight.green(), light.green());
        blue += product(share, weight.blue(), light.blue());
    }

    /** Never infinity times 0, which would be no number. */
    private static double product(double share, double weight, double light) {
        return Math.min(share * weight, Double.MAX_VALUE) * light;
    }

    Color total() {
        return new Color(red, green, blue);
    }
}
