package raytracing.preview;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.awt.image.BufferedImage;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.render.Region;

class ShownPictureTest {
    /** A part of a picture, 40 x 30 pixels. */
    private static final Region REGION = new Region(100, 50, 140, 80);
    private static final int ORANGE = 0xff8000;
    private static final Color ORANGE_LIGHT = new Color(7, 0.5, 0);

    private final ShownPicture picture = new ShownPicture(REGION);

    private static Film film(int width, int height) {
        Film film = new Film(width, height);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                film.set(x, y, x / 255.0, y / 255.0, 1);
            }
        }
        return film;
    }

    private static int rgb(BufferedImage image, int x, int y) {
        return image.getRGB(x, y) & 0xffffff;
    }

    @Test
    void whatIsNotDrawnIsAQuietChequer() {
        BufferedImage image = picture.image().orElseThrow();
        assertEquals(40, image.getWidth());
        assertEquals(30, image.getHeight());
        assertEquals(rgb(image, 0, 0), rgb(image, 8, 8));
        assertNotEquals(rgb(image, 0, 0), rgb(image, 8, 0));
        assertEquals("100, 50:  not drawn yet", picture.describe(0, 0));
    }

    @Test
    void aSquareHasOneColourAndNothingElseHas() {
        picture.showSquare(new Region(116, 66, 132, 80), ORANGE_LIGHT);
        BufferedImage image = picture.image().orElseThrow();
        for (int y = 0; y < 30; y++) {
            for (int x = 0; x < 40; x++) {
                assertEquals(x >= 16 && x < 32 && y >= 16, rgb(image, x, y) == ORANGE);
            }
        }
        assertEquals("116, 66:  not drawn yet", picture.describe(16, 16));
    }

    /** The film is of pixels from (98, 49) on. */
    @Test
    void aTileIsWhatTheFilmWillBecome() {
        Film film = film(50, 40);
        Region filmed = new Region(98, 49, 148, 89);
        picture.showTile(new Region(100, 60, 140, 70), film, filmed);
        BufferedImage image = picture.image().orElseThrow();
        BufferedImage expected = film.toImage();
        for (int y = 10; y < 20; y++) {
            for (int x = 0; x < 40; x++) {
                assertEquals(rgb(expected, x + 2, y + 1), rgb(image, x, y));
            }
        }
        assertEquals("107, 60:  9 11 255", picture.describe(7, 10));
        assertEquals("107, 59:  not drawn yet", picture.describe(7, 9));
    }

    @Test
    void changesAreTheRectangleAroundThemAndTakenOnce() {
        assertEquals(Optional.empty(), picture.takeChanges());
        picture.showSquare(new Region(120, 52, 124, 56), ORANGE_LIGHT);
        assertEquals(Optional.of(new Region(20, 2, 24, 6)), picture.takeChanges());
        assertEquals(Optional.empty(), picture.takeChanges());
        picture.showSquare(new Region(104, 70, 108, 74), ORANGE_LIGHT);
        picture.showTile(new Region(136, 66, 140, 70), film(4, 4), new Region(136, 66, 140, 70));
        assertEquals(Optional.of(new Region(4, 16, 40, 24)), picture.takeChanges());
    }

    @Test
    void anEmptyTileIsNoChange() {
        picture.showTile(new Region(100, 80, 140, 80), film(40, 30), REGION);
        assertEquals(Optional.empty(), picture.takeChanges());
    }

    @Test
    void aReleasedPictureTakesAndKeepsNothing() {
        picture.release();
        picture.showSquare(new Region(116, 66, 132, 80), ORANGE_LIGHT);
        picture.showTile(REGION, film(40, 30), REGION);
        assertEquals(0, picture.coarseLooks().length);
        assertEquals(Optional.empty(), picture.takeChanges());
        assertEquals(Optional.empty(), picture.image());
    }
}
