/**
 * Turns pixels into film, tile by tile on all cores; knows no formula for light or shape. A {@code Renderer} is a prepared
 * picture, a {@code Drawing} draws it band by band, a {@code TilePass} deals the tiles of a band to threads and goes through
 * the pixels of a tile, a {@code PixelPainter} paints a pixel, and a {@code PixelLight} finds its light.
 */
package raytracing.render;
