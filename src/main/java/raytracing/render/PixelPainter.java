package raytracing.render;

/** What a pass does with each pixel. Several threads call it at once, about different tiles, each with its own light. */
interface PixelPainter {
    /** The pixels of a tile that are painted. */
    default Region paintedPixels(Region tile) {
        return tile;
    }

    /** Paints a pixel of the picture. */
    void paint(int x, int y, PixelLight light);

    /** Reports that all pixels of a tile are painted. */
    void finished(Region tile, PixelLight light);
}
