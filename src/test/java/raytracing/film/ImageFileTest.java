package raytracing.film;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.Folders;
import raytracing.color.Color;

class ImageFileTest {
    @TempDir
    private Path folder;

    private static Film film() {
        Film film = new Film(8, 4);
        for (int x = 0; x < 8; x++) {
            for (int y = 0; y < 4; y++) {
                film.set(x, y, x / 7.0, y / 3.0, 0.2);
            }
        }
        return film;
    }

    @ParameterizedTest
    @ValueSource(strings = {"PNG", "BMP"})
    void losslessFormatsGiveEveryPixelBack(ImageFormat format) throws IOException {
        Path path = folder.resolve("picture");
        new ImageFile(path, format).write(film());
        BufferedImage read = ImageIO.read(path.toFile());
        BufferedImage written = film().toImage();
        for (int x = 0; x < 8; x++) {
            for (int y = 0; y < 4; y++) {
                assertEquals(written.getRGB(x, y), read.getRGB(x, y));
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"PNG, png", "JPEG, JPEG", "BMP, bmp", "GIF, gif"})
    void theFileIsOfTheFormatAskedFor(ImageFormat format, String imageIoName) throws IOException {
        Path path = folder.resolve("picture");
        new ImageFile(path, format).write(film());
        try (var stream = ImageIO.createImageInputStream(path.toFile())) {
            assertEquals(imageIoName, ImageIO.getImageReaders(stream).next().getFormatName());
        }
        assertEquals(8, ImageIO.read(path.toFile()).getWidth());
    }

    /** The default quality of ImageIO is off by up to 11 steps in this pattern of greys. */
    @Test
    void jpegKeepsGreysWithinAFewSteps() throws IOException {
        Film pattern = new Film(64, 64);
        for (int x = 0; x < 64; x++) {
            for (int y = 0; y < 64; y++) {
                double light = (x ^ y) / 63.0;
                pattern.set(x, y, light, light, light);
            }
        }
        Path path = folder.resolve("pattern.jpg");
        new ImageFile(path, ImageFormat.JPEG).write(pattern);
        BufferedImage read = ImageIO.read(path.toFile());
        int largest = 0;
        for (int x = 0; x < 64; x++) {
            for (int y = 0; y < 64; y++) {
                largest = Math.max(largest, Math.abs((read.getRGB(x, y) & 0xff) - (pattern.toImage().getRGB(x, y) & 0xff)));
            }
        }
        assertTrue(largest <= 6, "off by " + largest);
    }

    @Test
    void nothingButTheFinishedFileIsLeft() throws IOException {
        new ImageFile(folder.resolve("picture.png"), ImageFormat.PNG).write(film());
        assertEquals(List.of("picture.png"), Folders.names(folder));
    }

    @ParameterizedTest
    @EnumSource
    void aPreparedFileGetsTheSameBytesAsAnUnpreparedOne(ImageFormat format) throws IOException {
        ImageFile prepared = new ImageFile(folder.resolve("prepared"), format);
        prepared.prepare();
        prepared.write(film());
        new ImageFile(folder.resolve("unprepared"), format).write(film());
        assertEquals(-1, Files.mismatch(folder.resolve("prepared"), folder.resolve("unprepared")));
        assertEquals(List.of("prepared", "unprepared"), Folders.names(folder));
    }

    @Test
    void anOlderFileIsReplaced() throws IOException {
        Path path = folder.resolve("picture.png");
        Files.writeString(path, "older");
        new ImageFile(path, ImageFormat.PNG).write(film());
        assertEquals(4, ImageIO.read(path.toFile()).getHeight());
    }

    @Test
    void aLinkStaysALinkAndItsTargetIsReplaced() throws IOException {
        Path target = Files.writeString(folder.resolve("target.png"), "older");
        Path link = Files.createSymbolicLink(folder.resolve("link.png"), target);
        new ImageFile(link, ImageFormat.PNG).write(film());
        assertTrue(Files.isSymbolicLink(link));
        assertEquals(8, ImageIO.read(target.toFile()).getWidth());
    }

    /** The target becomes a folder after the check, so the last step fails: the picture is complete, the move is not. */
    @Test
    void afterAFailureNothingIsLeftAndWhatStoodThereStillDoes() throws IOException {
        Path path = Files.createDirectory(folder.resolve("picture.png"));
        Files.writeString(path.resolve("inside"), "older");
        assertThrows(IOException.class, () -> new ImageFile(path, ImageFormat.PNG).write(film()));
        assertEquals(List.of("picture.png"), Folders.names(folder));
        assertArrayEquals("older".getBytes(), Files.readAllBytes(path.resolve("inside")));
    }

    @Test
    void obstaclesAreFoundBeforeAnyWorkWhichLeavesNothing() throws IOException {
        Path existing = Files.writeString(folder.resolve("older.png"), "older");
        assertEquals(Optional.empty(), obstacle(existing));
        assertEquals(Optional.empty(), obstacle(folder.resolve("new.png")));
        assertEquals(Optional.of("no such folder"), obstacle(folder.resolve("none/new.png")));
        assertEquals(Optional.of("no such folder"), obstacle(existing.resolve("new.png")));
        assertEquals(Optional.of("is a folder, expected a file name"), obstacle(folder));
        assertEquals(Optional.of("exists and may not be replaced"), obstacle(Path.of("/dev/null")));
        assertEquals(List.of("older.png"), Folders.names(folder));
    }

    private Optional<String> obstacle(Path path) throws IOException {
        return new ImageFile(path, ImageFormat.PNG).obstacle(folder.resolve("scene.txt"));
    }

    @Test
    void aFolderThatIsGoneIsSaid() throws IOException {
        Path gone = Files.createDirectory(folder.resolve("gone"));
        ImageFile file = new ImageFile(gone.resolve("picture.png"), ImageFormat.PNG);
        assertEquals(Optional.empty(), file.obstacle(folder.resolve("scene.txt")));
        Files.delete(gone);
        IOException failure = assertThrows(IOException.class, () -> file.write(film()));
        assertTrue(failure.getMessage().endsWith("its folder is no longer there"), failure.getMessage());
    }

    @ParameterizedTest
    @CsvSource({"a.png, PNG", "a.PNG, PNG", "b.c.jpg, JPEG", "a.jpeg, JPEG", "x/y.bmp, BMP", "a.gif, GIF"})
    void theEndingChoosesTheFormat(String name, ImageFormat expected) {
        assertEquals(Optional.of(expected), ImageFormat.ofEnding(name));
    }

    @ParameterizedTest
    @ValueSource(strings = {"a.tif", "png", "a.", "a", "a.png.txt", "a.pngx", ""})
    void anUnknownEndingHasNoFormat(String name) {
        assertFalse(ImageFormat.ofEnding(name).isPresent());
    }

    /** Rows of a film, some at a time; keeps a list of the bands that were read. */
    private record Cut(Film film, int bandHeight, List<Integer> read) implements Bands {
        @Override
        public int width() {
            return film.width();
        }

        @Override
        public int height() {
            return film.height();
        }

        @Override
        public Film band(int index) {
            read.add(index);
            int top = index * bandHeight;
            return film.part(0, top, film.width(), Math.min(bandHeight, film.height() - top));
        }
    }

    @ParameterizedTest
    @EnumSource
    void aPictureInBandsGivesTheSameFileAsInOnePiece(ImageFormat format) throws IOException {
        Path whole = folder.resolve("whole");
        Path cut = folder.resolve("cut");
        new ImageFile(whole, format).write(film());
        new ImageFile(cut, format).write(new Cut(film(), 3, new ArrayList<>()));
        assertEquals(-1, Files.mismatch(whole, cut));
    }

    @ParameterizedTest
    @EnumSource
    void everyBandIsAskedForOnce(ImageFormat format) throws IOException {
        List<Integer> read = new ArrayList<>();
        new ImageFile(folder.resolve("picture"), format).write(new Cut(film(), 1, read));
        assertEquals(List.of(0, 1, 2, 3), read.stream().sorted().toList());
    }

    @Test
    void whatALaterBandThrowsLeavesTheOlderFileAndNothingElse() throws IOException {
        Path path = folder.resolve("picture.png");
        Files.writeString(path, "older");
        List<Integer> takesOne = new ArrayList<>() {
            private static final long serialVersionUID = 1;

            @Override
            public boolean add(Integer index) {
                if (index > 0) {
                    throw new IllegalStateException("as expected");
                }
                return super.add(index);
            }
        };
        Bands broken = new Cut(film(), 2, takesOne);
        assertThrows(IllegalStateException.class, () -> new ImageFile(path, ImageFormat.PNG).write(broken));
        assertEquals("older", Files.readString(path));
        assertEquals(List.of("picture.png"), Folders.names(folder));
    }

    @Test
    void gapsAreTransparentInAPng() throws IOException {
        Film film = film();
        film.leaveGap(2, 3, Color.WHITE);
        Path path = folder.resolve("picture.png");
        new ImageFile(path, ImageFormat.PNG).write(film);
        BufferedImage read = ImageIO.read(path.toFile());
        assertEquals(0, read.getRGB(2, 3));
        assertEquals(film.toImage().getRGB(3, 2), read.getRGB(3, 2));
    }

    @Test
    void gapsShowWhatStandsInsteadInABmp() throws IOException {
        Film film = film();
        film.leaveGap(2, 3, Color.WHITE);
        Path path = folder.resolve("picture.bmp");
        new ImageFile(path, ImageFormat.BMP).write(film);
        assertEquals(0xffffffff, ImageIO.read(path.toFile()).getRGB(2, 3));
    }
}
