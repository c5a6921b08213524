package raytracing.film;

import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** The kinds of picture files that this program writes. */
public enum ImageFormat {
    /** Every pixel as computed, compressed without loss. */
    PNG(Integer.MAX_VALUE, "png"),

    /** Compressed with loss. */
    JPEG(65_500, "jpg", "jpeg"),

    /** Every pixel as computed, not compressed. */
    BMP(Integer.MAX_VALUE, "bmp"),

    /** Reduced to 256 colours. */
    GIF(65_535, "gif");

    private final int longestSide;
    private final List<String> endings;

    ImageFormat(int longestSide, String... endings) {
        this.longestSide = longestSide;
        this.endings = List.of(endings);
    }

    /**
     * The format that a file's name asks for.
     *
     * @param fileName a name or path; the letter case of its ending does not matter
     * @return the format, or none if the name has no ending or one that stands for no format
     */
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

    /**
     * The longest width or height that the format can hold.
     *
     * @return in pixels
     */
    public int longestSide() {
        return longestSide;
    }

    /** What ImageIO calls the format. */
    String imageIoName() {
        return endings.get(0);
    }
}
