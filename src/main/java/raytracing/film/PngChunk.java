package raytracing.film;

/** What a PNG file consists of (ISO/IEC 15948, Portable Network Graphics): a signature, then chunks of some kinds. */
final class PngChunk {
    /** The first 8 bytes of a file, big-endian as all numbers of the format. */
    static final long SIGNATURE = 0x89504e470d0a1a0aL;

    /** {@code IHDR}: the size and the kind of the pixels. */
    static final int HEADER = 0x49484452;
    static final int HEADER_LENGTH = 13;

    /** {@code IDAT}: a part of the pixels, which are compressed together. */
    static final int PIXELS = 0x49444154;

    /** {@code tRNS}. */
    static final int TRANSPARENT_COLOR = 0x74524e53;

    /** {@code IEND}. */
    static final int END = 0x49454e44;

    /** Bytes before the data of a chunk, its length and its kind; and bytes after it. */
    static final int START_LENGTH = 8;
    static final int CHECKSUM_LENGTH = 4;

    /** Bits a channel. */
    static final int DEPTH = 8;

    /** Kinds of colours, after which come bytes for compression, filter and interlacing: 0 for the usual ones. */
    static final int GREY = 0;
    static final int RGB = 2;
    static final int GREY_AND_ALPHA = 4;
    static final int RGB_AND_ALPHA = 6;

    private PngChunk() {
    }
}
