package raytracing.film;

import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** The kinds of picture files that this program writes. */
public enum ImageFormat {
    /** Every pixel as computed, compressed without loss. */
    PNG(Film.MOST_PIXELS, Long.MAX_VALUE, Reading.DOWN, "png"),

    /** Compressed with loss. */
    JPEG(65_500, Integer.MAX_VALUE - 8, Reading.WHOLE, "jpg", "jpeg"),

    /** Every pixel as computed, not compressed: 2 GB at most, with rows of up to 3 bytes more than their pixels need. */
    BMP(Film.MOST_PIXELS, 500_000_000, Reading.UP, "bmp"),

    /** Reduced to 256 colours. */
    GIF(65_535, Integer.MAX_VALUE - 8, Reading.WHOLE, "gif");

    private final int longestSide;
    private final long mostPixels;
    private final Reading reading;
    private final List<String> endings;

    ImageFormat(int longestSide, long mostPixels, Reading reading, String... endings) {
        this.longestSide = longestSide;
        this.mostPixels = mostPixels;
        this.reading = reading;
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

    /**
     * The largest picture that a file of this format can hold.
     *
     * @return width times height
     */
    public long mostPixels() {
        return mostPixels;
    }

    /**
     * Whether what is missing in a picture is transparent in its file. The header of a file of several bands is written
     * before anybody knows that something will be.
     *
     * @param bands of the picture
     * @return false if something else stands in the gaps
     */
    public boolean showsGaps(Bands bands) {
        return this == PNG && bands.count() == 1;
    }

    /** How ImageIO's writer reads the picture. */
    Reading reading() {
        return reading;
    }

    /** What ImageIO calls the format. */
    String imageIoName() {
        return endings.get(0);
    }

    /** How a writer reads a picture. */
    enum Reading {
        /** Row by row from the top, each once, keeping none. */
        DOWN,

        /** Row by row from the bottom, each once, keeping none. */
        UP,

        /** As it likes. */
        WHOLE
    }
}
