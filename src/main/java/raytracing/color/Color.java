package raytracing.color;

/**
 * Linear light, or a factor on it: 1 is full, more is allowed, below 0 is not. Always finite, so that a factor of 0 gives 0
 * whatever it is multiplied by. Nothing here is encoded for a screen; the film does that.
 */
public record Color(double red, double green, double blue) {
    /** No light; the factor that stops all of it. */
    public static final Color BLACK = new Color(0, 0, 0);

    /** Full light; the factor that changes nothing. */
    public static final Color WHITE = new Color(1, 1, 1);

    /** Each channel at least 0, may be infinite: light beyond every double becomes the largest double. */
    public Color {
        red = Math.min(red, Double.MAX_VALUE);
        green = Math.min(green, Double.MAX_VALUE);
        blue = Math.min(blue, Double.MAX_VALUE);
    }

    /** Whether every channel is 0. */
    public boolean isBlack() {
        return red == 0 && green == 0 && blue == 0;
    }
}
