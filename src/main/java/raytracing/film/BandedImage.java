package raytracing.film;

import java.awt.Image;
import java.awt.Rectangle;
import java.awt.image.ColorModel;
import java.awt.image.DirectColorModel;
import java.awt.image.Raster;
import java.awt.image.RenderedImage;
import java.awt.image.SampleModel;
import java.awt.image.WritableRaster;
import java.util.Arrays;
import java.util.Vector;

/**
 * A picture as ImageIO's writers read it, row by row, with only the band of the last row in memory; each band is a tile. Its
 * pixels, and so the files, are those of {@link Film#toImage()}.
 */
final class BandedImage implements RenderedImage {
    private static final ColorModel RGB = new DirectColorModel(24, 0xff0000, 0xff00, 0xff);

    private final Bands bands;
    private final int[] row;
    private Film band;
    private int index;

    /** A picture whose band {@code first} will be read first, which is drawn here. */
    BandedImage(Bands bands, int first) {
        this.bands = bands;
        row = new int[bands.width()];
        index = first;
        band = bands.band(first);
    }

    @Override
    public Raster getData(Rectangle part) {
        WritableRaster copy = RGB.createCompatibleWritableRaster(part.width, part.height);
        for (int y = 0; y < part.height; y++) {
            readRow(part.y + y);
            copy.setDataElements(0, y, part.width, 1, Arrays.copyOfRange(row, part.x, part.x + part.width));
        }
        return copy.createTranslatedChild(part.x, part.y);
    }

    private void readRow(int y) {
        if (y / bands.bandHeight() != index) {
            index = y / bands.bandHeight();
            band = new Film(1, 1);           // frees the old band first: memory may hold only one
            band = bands.band(index);
        }
        band.encodeRow(y - index * bands.bandHeight(), row);
    }

    @Override
    public Raster getData() {
        return getData(new Rectangle(0, 0, getWidth(), getHeight()));
    }

    @Override
    public WritableRaster copyData(WritableRaster raster) {
        WritableRaster target = raster == null ? RGB.createCompatibleWritableRaster(getWidth(), getHeight()) : raster;
        target.setRect(getData(target.getBounds()));
        return target;
    }

    @Override
    public Raster getTile(int tileX, int tileY) {
        return getData(new Rectangle(0, tileY * getTileHeight(), getWidth(),
            Math.min(getTileHeight(), getHeight() - tileY * getTileHeight())));
    }

    @Override
    public ColorModel getColorModel() {
        return RGB;
    }

    /** The model of one row, as no writer reads more at once. */
    @Override
    public SampleModel getSampleModel() {
        return RGB.createCompatibleSampleModel(getWidth(), 1);
    }

    @Override
    public int getWidth() {
        return bands.width();
    }

    @Override
    public int getHeight() {
        return bands.height();
    }

    @Override
    public int getMinX() {
        return 0;
    }

    @Override
    public int getMinY() {
        return 0;
    }

    @Override
    public int getNumXTiles() {
        return 1;
    }

    @Override
    public int getNumYTiles() {
        return bands.count();
    }

    @Override
    public int getMinTileX() {
        return 0;
    }

    @Override
    public int getMinTileY() {
        return 0;
    }

    @Override
    public int getTileWidth() {
        return getWidth();
    }

    @Override
    public int getTileHeight() {
        return bands.bandHeight();
    }

    @Override
    public int getTileGridXOffset() {
        return 0;
    }

    @Override
    public int getTileGridYOffset() {
        return 0;
    }

    /** {@inheritDoc} It has none, which the interface has as null. */
    @Override
    public Vector<RenderedImage> getSources() {
        return null;
    }

    @Override
    public Object getProperty(String name) {
        return Image.UndefinedProperty;
    }

    /** {@inheritDoc} It has none, which the interface has as null. */
    @Override
    public String[] getPropertyNames() {
        return null;
    }
}
