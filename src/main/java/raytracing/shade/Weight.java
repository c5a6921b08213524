package raytracing.shade;

import raytracing.color.Color;

/** The factor on whatever a ray sees, in the pixel: shrinks on the ray's way. Always finite. One thread, ray after ray. */
final class Weight {
    private double red;
    private double green;
    private double blue;

    void set(double red, double green, double blue) {
        this.red = Math.min(red, Double.MAX_VALUE);
        this.green = Math.min(green, Double.MAX_VALUE);
        this.blue = Math.min(blue, Double.MAX_VALUE);
    }

    /** Becomes another weight behind a coloured filter. */
    void setFiltered(Weight weight, Color filter) {
        set(weight.red * filter.red(), weight.green * filter.green(), weight.blue * filter.blue());
    }

    /** Shrinks behind a grey filter. */
    void scale(double factor) {
        set(factor * red, factor * green, factor * blue);
    }

    double red() {
        return red;
    }

    double green() {
        return green;
    }

    double blue() {
        return blue;
    }

    double max() {
        return Math.max(red, Math.max(green, blue));
    }
}
