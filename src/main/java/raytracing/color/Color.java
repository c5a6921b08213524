package raytracing.color;

/**
 * Linear light, or a factor on it, in red, green and blue: 1 is full, more is allowed, below 0 is not. Always finite, so
 * that a factor of 0 gives 0 whatever it meets. Immutable. Nothing here encodes; the film does.
 *
 * @param red red part
 * @param green green part
 * @param blue blue part
 */
public record Color(double red, double green, double blue) {
    private static final double LARGEST = Double.MAX_VALUE;

    /** No light; the factor that stops all of it. */
    public static final Color BLACK = new Color(0, 0, 0);

    /** Full light; the factor that changes nothing. */
    public static final Color WHITE = new Color(1, 1, 1);

    /**
     * Light beyond every double becomes the largest there is.
     *
     * @param red at least 0, may be infinite
     * @param green at least 0, may be infinite
     * @param blue at least 0, may be infinite
     */
    public Color {
        red = Math.min(red, LARGEST);
        green = Math.min(green, LARGEST);
        blue = Math.min(blue, LARGEST);
    }

    /**
     * Light after a coloured filter, channel by channel.
     *
     * @param filter factor for each channel
     * @return this times filter
     */
    public Color times(Color filter) {
        return new Color(red * filter.red, green * filter.green, blue * filter.blue);
    }

    /**
     * Light after a grey filter.
     *
     * @param factor for all channels, at least 0
     * @return factor times this
     */
    public Color times(double factor) {
        return new Color(factor * red, factor * green, factor * blue);
    }

    /**
     * Whether this light, or what passes this filter, is nothing at all.
     *
     * @return true if every channel is 0
     */
    public boolean isBlack() {
        return red == 0 && green == 0 && blue == 0;
    }

    /**
     * The brightest channel.
     *
     * @return the largest of red, green and blue
     */
    public double max() {
        return Math.max(red, Math.max(green, blue));
    }
}
