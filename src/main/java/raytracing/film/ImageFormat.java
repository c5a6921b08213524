package raytracing.film;

import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** The kinds of picture files that this program writes. */
public enum ImageFormat {
    /** Every pixel as computed, compressed without loss. */
    PNG(Film.MOST_PIXELS, Long.MAX_VALUE, "png"),

    /** Compressed with loss. */
    JPEG(65_500, Integer.MAX_VALUE - 8, "jpg", "jpeg"),

    /** Every pixel as computed, not compressed: 2 GB at most, with rows of up to 3 bytes more than their pixels need. */
    BMP(Film.MOST_PIXELS, 500_000_000, "bmp"),

    /** Reduced to 256 colours. */
    GIF(65_535, Integer.MAX_VALUE - 8, "gif");

    private final int longestSide;
    private final long mostPixels;
    private final List<String> endings;

    ImageFormat(int longestSide, long mostPixels, String... endings) {
        this.longestSide = longestSide;
        this.mostPixels = mostPixels;
        this.endings = List.of(endings);
    }

    /** The format that belongs to the ending, in any case, of a name or path; none if there is no such format. */
    public static Optional<ImageFormat> ofEnding(String fileName) {
        String lowerCase = fileName.toLowerCase(Locale.ROOT);
        for (ImageFormat format : values()) {
            for (String ending : format.endings) {
                if (lowerCase.endsWith("." + ending)) {
                    return Optional.of(format);
                }
            }
        }
        return Optional.empty();
    }

    /** The largest width or height, in pixels, that the format can hold. */
    public int longestSide() {
        return longestSide;
    }

    /** The largest width times height that a file of this format can hold. */
    public long mostPixels() {
        return mostPixels;
    }

    /**
     * Whether the gaps of a picture are transparent in its file. They are not in a file of several bands, whose header is
     * written before it is known that there will be gaps.
     */
    public boolean showsGaps(Bands bands) {
        return this == PNG && bands.count() == 1;
    }

    /** Whether a file has other colours than its picture, so that it is smaller. */
    public boolean isLossy() {
        return this == JPEG || this == GIF;
    }
}
