package raytracing.film;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import java.util.function.IntUnaryOperator;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.ImageOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Picture files of all kinds, read as 8 bits a channel. */
class StoredPictureTest {
    private static final int WIDTH = 32;
    private static final int HEIGHT = 24;
    private static final String UNREADABLE =
        "cannot be read to its end, as it is damaged, cut off or of a rare kind; save it again as png";
    private static final String NO_PICTURE = "is no picture that can be read, expected a png, jpg, bmp or gif";

    private static final byte[] SIGNATURE = {(byte) 137, 80, 78, 71, 13, 10, 26, 10};

    @TempDir
    private Path folder;

    /** The pixels of a file, read as a picture that is loaded, and from its open file. */
    private static int[] pixels(Path file) throws IOException {
        try (StoredPicture picture = StoredPicture.open(file)) {
            int[] open = pixels(picture.rows(), picture.width(), picture.height());
            picture.load();
            int[] loaded = pixels(picture.rows(), picture.width(), picture.height());
            assertTrue(Arrays.equals(open, loaded));
            return loaded;
        }
    }

    private static int[] pixels(PixelRows rows, int width, int height) throws IOException {
        int[] pixels = new int[width * height];
        int[] row = new int[width];
        for (int y = 0; y < height; y++) {
            rows.next(row);
            System.arraycopy(row, 0, pixels, y * width, width);
        }
        return pixels;
    }

    private static String reason(Path file) {
        return assertThrows(FileSystemException.class, () -> pixels(file)).getReason();
    }

    /** Writes an image with ImageIO, interlaced if that is asked for. */
    private Path written(BufferedImage image, String format, boolean isInterlaced) throws IOException {
        Path file = folder.resolve("picture." + format);
        ImageWriter writer = ImageIO.getImageWritersByFormatName(format).next();
        try (ImageOutputStream output = ImageIO.createImageOutputStream(file.toFile())) {
            ImageWriteParam parameters = writer.getDefaultWriteParam();
            if (isInterlaced) {
                parameters.setProgressiveMode(ImageWriteParam.MODE_DEFAULT);
            }
            writer.setOutput(output);
            writer.write(null, new IIOImage(image, null, null), parameters);
        } finally {
            writer.dispose();
        }
        return file;
    }

    /** Each channel takes all values, in another order. */
    private static int color(int i) {
        return (i & 0xff) << 16 | (7 * i & 0xff) << 8 | 255 - i & 0xff;
    }

    private static BufferedImage colors(int type) {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, type);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            image.setRGB(i % WIDTH, i / WIDTH, 0xff000000 | color(i));
        }
        return image;
    }

    private static void assertPixels(IntUnaryOperator expected, int[] pixels) {
        assertEquals(WIDTH * HEIGHT, pixels.length);
        for (int i = 0; i < pixels.length; i++) {
            assertEquals(Integer.toHexString(expected.applyAsInt(i)), Integer.toHexString(pixels[i]), "pixel " + i);
        }
    }

    @ParameterizedTest
    @CsvSource({"png, false", "png, true", "bmp, false"})
    void coloursAreThoseOfTheFile(String format, boolean isInterlaced) throws IOException {
        assertPixels(StoredPictureTest::color, pixels(written(colors(BufferedImage.TYPE_INT_RGB), format, isInterlaced)));
    }

    /** Java would show grey 128 of such a file as 188, since it takes grey for linear light. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void greyIsTheSameInAllChannels(boolean isInterlaced) throws IOException {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_BYTE_GRAY);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            image.getRaster().setSample(i % WIDTH, i / WIDTH, 0, i & 0xff);
        }
        assertPixels(i -> 0x10101 * (i & 0xff), pixels(written(image, "png", isInterlaced)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "bmp"})
    void twoColoursAreBlackAndWhite(String format) throws IOException {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_BYTE_BINARY);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            image.setRGB(i % WIDTH, i / WIDTH, i % 3 == 0 ? 0xffffffff : 0xff000000);
        }
        assertPixels(i -> i % 3 == 0 ? 0xffffff : 0, pixels(written(image, format, false)));
    }

    /** 257 n of 65,535 is n of 255; half a step of 255 more is 128.5 of 65,535, where rounding begins. */
    @ParameterizedTest
    @CsvSource({"0, 0", "128, 0", "129, 1", "-128, 0", "-129, -1"})
    void sixteenBitsAreRoundedToEight(int more, int steps) throws IOException {
        BufferedImage image = new BufferedImage(new ComponentColorModel(ColorSpace.getInstance(ColorSpace.CS_sRGB), false,
            false, Transparency.OPAQUE, DataBuffer.TYPE_USHORT), raster16(3, more), false, null);
        assertPixels(i -> 0x10101 * (1 + i % 254 + steps), pixels(written(image, "png", false)));
        BufferedImage grey = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_USHORT_GRAY);
        grey.setData(raster16(1, more));
        assertPixels(i -> 0x10101 * (1 + i % 254 + steps), pixels(written(grey, "png", false)));
    }

    private static WritableRaster raster16(int channels, int more) {
        WritableRaster raster =
            Raster.createInterleavedRaster(DataBuffer.TYPE_USHORT, WIDTH, HEIGHT, channels, null);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            for (int channel = 0; channel < channels; channel++) {
                raster.setSample(i % WIDTH, i / WIDTH, channel, 257 * (1 + i % 254) + more);
            }
        }
        return raster;
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "gif"})
    void aPaletteIsLookedUp(String format) throws IOException {
        int[] palette = new int[256];
        Arrays.setAll(palette, StoredPictureTest::color);
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_BYTE_INDEXED,
            new IndexColorModel(8, 256, palette, 0, false, -1, DataBuffer.TYPE_BYTE));
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            image.getRaster().setSample(i % WIDTH, i / WIDTH, 0, 5 * i & 0xff);
        }
        assertPixels(i -> color(5 * i & 0xff), pixels(written(image, format, false)));
    }

    @Test
    void aTransparentColourOfAPaletteIsBlack() throws IOException {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_BYTE_INDEXED,
            new IndexColorModel(8, 2, new int[] {0xff00ff, 0x80ff40}, 0, false, 0, DataBuffer.TYPE_BYTE));
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            image.getRaster().setSample(i % WIDTH, i / WIDTH, 0, i & 1);
        }
        assertPixels(i -> (i & 1) == 0 ? 0 : 0x80ff40, pixels(written(image, "gif", false)));
    }

    /** Colour c with alpha a is c a / 255 in front of black. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void whatIsTransparentIsSeenInFrontOfBlack(boolean isInterlaced) throws IOException {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_ARGB);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            image.setRGB(i % WIDTH, i / WIDTH, (i & 0xff) << 24 | 0xff00b4);
        }
        assertPixels(i -> (i & 0xff) << 16 | (int) Math.round((i & 0xff) * 180 / 255.0),
            pixels(written(image, "png", isInterlaced)));
    }

    @Test
    void jpegIsReadAsImageIoReadsIt() throws IOException {
        Path file = written(colors(BufferedImage.TYPE_INT_RGB), "jpg", false);
        BufferedImage read = ImageIO.read(file.toFile());
        assertPixels(i -> read.getRGB(i % WIDTH, i / WIDTH) & 0xffffff, pixels(file));
    }

    @ParameterizedTest
    @EnumSource
    void someRowsAtATimeGiveTheSameAsAll(ImageFormat format) throws IOException {
        Path file = written(colors(BufferedImage.TYPE_INT_RGB), format.name(), false);
        for (long most : new long[] {1, 7 * WIDTH, WIDTH * HEIGHT}) {
            try (ImageInputStream stream = ImageIO.createImageInputStream(file.toFile())) {
                PixelRows rows = ImageIoRows.of(stream, most).orElseThrow();
                assertTrue(Arrays.equals(pixels(file), pixels(rows, WIDTH, HEIGHT)), most + " pixels");
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void aFileThatIsCutOffIsNoticed(ImageFormat format) throws IOException {
        byte[] whole = Files.readAllBytes(written(colors(BufferedImage.TYPE_INT_RGB), format.name(), false));
        Path cut = folder.resolve("cut");
        for (int length : new int[] {30, whole.length / 2, whole.length * 9 / 10}) {
            Files.write(cut, Arrays.copyOf(whole, length));
            assertEquals(UNREADABLE, reason(cut), length + " bytes of " + whole.length);
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aPngWithAWrongBitIsNoticed(boolean isInterlaced) throws IOException {
        Path file = written(colors(BufferedImage.TYPE_INT_RGB), "png", isInterlaced);
        byte[] bytes = Files.readAllBytes(file);
        bytes[bytes.length / 2] ^= 1;
        Files.write(file, bytes);
        assertEquals(UNREADABLE, reason(file));
    }

    /** The last of its four bytes; behind them are the checksum of the part and 12 bytes of the end. */
    @Test
    void pixelsOfAPngAreHeldToTheirChecksum() throws IOException {
        Path file = written(colors(BufferedImage.TYPE_INT_RGB), "png", false);
        byte[] bytes = Files.readAllBytes(file);
        bytes[bytes.length - 17] ^= 1;
        Files.write(file, bytes);
        assertEquals(UNREADABLE, reason(file));
    }

    @Test
    void whatIsNoPictureIsSaid() throws IOException {
        Path file = folder.resolve("picture.png");
        for (String text : new String[] {"x", "cam 0 0 -5  0 0 0  0 1 0  1 1\n", "BM", "GIF"}) {
            Files.writeString(file, text, StandardCharsets.ISO_8859_1);
            assertTrue(reason(file).equals(NO_PICTURE) || text.length() < 4 && reason(file).equals(UNREADABLE), text);
        }
        assertEquals("no such file, expected a picture", reason(folder.resolve("none.png")));
        assertEquals("is a folder, expected a picture", reason(folder));
        assertEquals("is no file, expected a picture", reason(Path.of("/dev/null")));
        assertEquals("is empty, expected a picture", reason(Files.createFile(folder.resolve("empty.png"))));
    }

    @Test
    void aLoadedPictureDoesNotNeedItsFileAnyMore() throws IOException {
        Path file = written(colors(BufferedImage.TYPE_INT_RGB), "png", false);
        try (StoredPicture picture = StoredPicture.open(file)) {
            picture.load();
            Files.writeString(file, "replaced");
            assertPixels(StoredPictureTest::color, pixels(picture.rows(), WIDTH, HEIGHT));
        }
    }

    /** Writes a PNG file of random bytes with one filter, its pixels in parts of some length, from the definition of PNG. */
    private static byte[] png(int kind, int channels, int filter, int partLength, byte[] values) throws IOException {
        ByteArrayOutputStream filtered = new ByteArrayOutputStream();
        try (DeflaterOutputStream packed = new DeflaterOutputStream(filtered)) {
            int length = channels * WIDTH;
            for (int y = 0; y < HEIGHT; y++) {
                packed.write(filter);
                for (int i = 0; i < length; i++) {
                    int left = i < channels ? 0 : values[y * length + i - channels] & 0xff;
                    int up = y == 0 ? 0 : values[(y - 1) * length + i] & 0xff;
                    int corner = i < channels || y == 0 ? 0 : values[(y - 1) * length + i - channels] & 0xff;
                    packed.write(values[y * length + i] - forecast(filter, left, up, corner));
                }
            }
        }
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        file.write(SIGNATURE);
        addPart(file, "IHDR", new byte[] {0, 0, 0, WIDTH, 0, 0, 0, HEIGHT, 8, (byte) kind, 0, 0, 0});
        addPart(file, "tEXt", "a remark".getBytes(StandardCharsets.US_ASCII));
        byte[] pixels = filtered.toByteArray();
        for (int i = 0; i < pixels.length; i += partLength) {
            addPart(file, "IDAT", Arrays.copyOfRange(pixels, i, Math.min(pixels.length, i + partLength)));
            addPart(file, "IDAT", new byte[0]);
        }
        addPart(file, "IEND", new byte[0]);
        return file.toByteArray();
    }

    private static int forecast(int filter, int left, int up, int corner) {
        return switch (filter) {
            case 1 -> left;
            case 2 -> up;
            case 3 -> (left + up) / 2;
            case 4 -> nearest(left + up - corner, left, up, corner);
            default -> 0;
        };
    }

    /** The first of three numbers that are as near as any. */
    private static int nearest(int number, int... choices) {
        int nearest = choices[0];
        for (int choice : choices) {
            nearest = Math.abs(choice - number) < Math.abs(nearest - number) ? choice : nearest;
        }
        return nearest;
    }

    private static void addPart(ByteArrayOutputStream file, String kind, byte[] content) throws IOException {
        DataOutputStream data = new DataOutputStream(file);
        CRC32 checksum = new CRC32();
        checksum.update(kind.getBytes(StandardCharsets.US_ASCII));
        checksum.update(content);
        data.writeInt(content.length);
        data.writeBytes(kind);
        data.write(content);
        data.writeInt((int) checksum.getValue());
    }

    @ParameterizedTest(name = "filter {0}, kind of colours {1}, {2} channels")
    @CsvSource({"0, 0, 1", "1, 0, 1", "2, 4, 2", "3, 4, 2", "4, 2, 3", "3, 2, 3", "1, 6, 4", "4, 6, 4", "4, 0, 1"})
    void everyFilterOfPngIsUndone(int filter, int kind, int channels) throws IOException {
        byte[] values = new byte[channels * WIDTH * HEIGHT];
        new Random(7).nextBytes(values);
        for (int partLength : new int[] {1, 100, 1 << 20}) {
            byte[] file = png(kind, channels, filter, partLength, values);
            int[] pixels = pixels(PngRows.of(new ByteArrayInputStream(file)).orElseThrow(), WIDTH, HEIGHT);
            assertPixels(i -> expected(values, channels, i), pixels);
            assertTrue(Arrays.equals(pixels, pixels(Files.write(folder.resolve("random.png"), file))));
        }
    }

    private static int expected(byte[] values, int channels, int i) {
        int alpha = channels % 2 == 0 ? values[channels * i + channels - 1] & 0xff : 255;
        int color = 0;
        for (int channel = 0; channel < 3; channel++) {
            int value = values[channels * i + (channels < 3 ? 0 : channel)] & 0xff;
            color = color << 8 | (int) Math.round(value * alpha / 255.0);
        }
        return color;
    }

    /** The second of two pixels, which differs from the first in one channel, is transparent. */
    @Test
    void aTransparentColourWithoutAPaletteIsBlack() throws IOException {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (DeflaterOutputStream pixels = new DeflaterOutputStream(packed)) {
            pixels.write(new byte[] {0, 10, 20, 31, 10, 20, 30});
        }
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        file.write(SIGNATURE);
        addPart(file, "IHDR", new byte[] {0, 0, 0, 2, 0, 0, 0, 1, 8, 2, 0, 0, 0});
        addPart(file, "tRNS", new byte[] {0, 10, 0, 20, 0, 30});
        addPart(file, "IDAT", packed.toByteArray());
        addPart(file, "IEND", new byte[0]);
        int[] pixels = pixels(Files.write(folder.resolve("picture.png"), file.toByteArray()));
        assertTrue(Arrays.equals(new int[] {0x0a141f, 0}, pixels), Arrays.toString(pixels));
    }

    /** Those of another kind are left to ImageIO. */
    @Test
    void onlyPngOfTheUsualKindIsReadRowByRow() throws IOException {
        assertTrue(isReadRowByRow(colors(BufferedImage.TYPE_INT_RGB), "png", false));
        assertTrue(isReadRowByRow(colors(BufferedImage.TYPE_INT_ARGB), "png", false));
        assertTrue(isReadRowByRow(colors(BufferedImage.TYPE_BYTE_GRAY), "png", false));
        assertTrue(!isReadRowByRow(colors(BufferedImage.TYPE_INT_RGB), "png", true));
        assertTrue(!isReadRowByRow(colors(BufferedImage.TYPE_BYTE_INDEXED), "png", false));
        assertTrue(!isReadRowByRow(colors(BufferedImage.TYPE_USHORT_GRAY), "png", false));
        assertTrue(!isReadRowByRow(colors(BufferedImage.TYPE_INT_RGB), "bmp", false));
    }

    private boolean isReadRowByRow(BufferedImage image, String format, boolean isInterlaced) throws IOException {
        return PngRows.of(new ByteArrayInputStream(Files.readAllBytes(written(image, format, isInterlaced)))).isPresent();
    }
}
