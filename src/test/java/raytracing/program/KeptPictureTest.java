package raytracing.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.SceneText;
import raytracing.film.Film;
import raytracing.film.ImageFile;
import raytracing.film.ImageFormat;
import raytracing.render.Cancellation.Leftovers;
import raytracing.render.Cancellation;
import raytracing.render.Drawing;
import raytracing.render.DrawingListener;
import raytracing.render.Region;
import raytracing.render.RenderSettings;
import raytracing.render.Renderers;
import raytracing.scene.Scene;

/** Pictures of which what is finished is kept, if they are stopped. */
class KeptPictureTest {
    private static final Scene SKY = SceneText.scene("cam 0 0 -5 0 0 0 0 1 0 1 1", "set 0 0 1 1 1");

    @TempDir
    private Path folder;

    /** A picture of the sky, which is blue, stopped when its first tile is finished. */
    private record Stopped(Cancellation cancellation) implements DrawingListener {
        @Override
        public int[] coarseLooks() {
            return new int[0];
        }

        @Override
        public void showSquare(Region square, raytracing.color.Color light) {
            // there are none
        }

        @Override
        public void showTile(Region tile, Film film, Region filmed) {
            cancellation.request();
        }
    }

    /** 2048 x 2048 pixels are the most that can be transparent. */
    @ParameterizedTest(name = "{0} {1} x {2}: {3}")
    @CsvSource({
        "PNG, 2048, 2048, transparent",
        "PNG, 2049, 2048, in the colour of the background",
        "BMP, 64,   64,   in the colour of the background",
    })
    void theMessageSaysWhatTheGapsOfTheFileLookLike(ImageFormat format, int width, int height, String gaps)
            throws Exception {
        RenderSettings settings = RenderSettings.DEFAULT.withSize(width, height).withWorkers(1, 16);
        Cancellation cancellation = new Cancellation();
        Drawing drawing = new Drawing(Renderers.of(SKY, settings), cancellation, Leftovers.KEEP, new Stopped(cancellation));
        Path file = folder.resolve("out");
        new ImageFile(file, format).write(drawing);
        String said = new Messages("out", format, settings).stopped(drawing);
        assertTrue(said.endsWith("what was finished is in the file; the rest is " + gaps), said);
        BufferedImage picture = ImageIO.read(file.toFile());
        assertEquals(Color.BLUE.getRGB(), picture.getRGB(0, 0));
        assertEquals(gaps.equals("transparent") ? 0 : Color.BLUE.getRGB(), picture.getRGB(width - 1, height - 1));
    }

    private Path finished(ImageFormat format, int width, int height, Leftovers leftovers) throws Exception {
        RenderSettings settings = RenderSettings.DEFAULT.withSize(width, height);
        Path file = folder.resolve(leftovers.name());
        new ImageFile(file, format).write(
            new Drawing(Renderers.of(SKY, settings), new Cancellation(), leftovers, DrawingListener.NONE));
        return file;
    }

    @ParameterizedTest
    @CsvSource({"PNG, 40, 30", "PNG, 2049, 2048", "JPEG, 40, 30", "BMP, 40, 30", "GIF, 40, 30"})
    void aFinishedPictureHasTheSameBytesWhetherItWouldBeKeptOrNot(ImageFormat format, int width, int height)
            throws Exception {
        assertEquals(-1, Files.mismatch(finished(format, width, height, Leftovers.KEEP),
            finished(format, width, height, Leftovers.DISCARD)));
    }
}
