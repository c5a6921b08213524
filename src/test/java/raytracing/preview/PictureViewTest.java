package raytracing.preview;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.color.Color;
import raytracing.render.Region;

/** What is painted, without a screen. */
class PictureViewTest {
    private static final int WIDTH = 500;
    private static final int HEIGHT = 400;

    private static BufferedImage painted(PictureView view) {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        view.paint(graphics);
        graphics.dispose();
        return image;
    }

    private static PictureView view(ShownPicture picture) {
        PictureView view = new PictureView(picture, () -> { });
        view.setSize(WIDTH, HEIGHT);
        painted(view);                           // now the viewport has the view's size
        return view;
    }

    /** The last pixels of a picture in colours of their own, up to its lower right corner. */
    private static ShownPicture withCorner(int width, int height) {
        ShownPicture picture = new ShownPicture(Region.whole(width, height));
        for (int y = Math.max(0, height - 9); y < height; y++) {
            for (int x = width - 9; x < width; x++) {
                picture.showSquare(new Region(x, y, x + 1, y + 1), new Color((width - x) / 20.0, (height - y) / 20.0, 0.5));
            }
        }
        return picture;
    }

    /** Up to the largest picture that is shown, and the longest ones. */
    @ParameterizedTest(name = "{0} x {1}")
    @CsvSource({"300, 200", "2000, 2000", "8192, 8192", "60000, 1000", "1000, 60000", "67108864, 1"})
    void everyPixelIsASquareAtTheLargestScale(int width, int height) {
        ShownPicture picture = withCorner(width, height);
        PictureView view = view(picture);
        for (int i = 0; i < 40; i++) {
            view.closer();
        }
        assertEquals(64, view.scale());
        Viewport[] corner = new Viewport[1];
        view.look(shown -> {
            corner[0] = shown.moved(Integer.MIN_VALUE, Integer.MIN_VALUE).moved(Integer.MIN_VALUE, 0).moved(200, 150);
            return corner[0];
        });
        BufferedImage image = painted(view);
        BufferedImage all = picture.image().orElseThrow();
        int onPicture = 0;
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                boolean isThere = corner[0].showsPictureAt(x, y);
                assertEquals(isThere ? all.getRGB(corner[0].column(x), corner[0].row(y)) : PictureView.SURROUNDINGS.getRGB(),
                    image.getRGB(x, y), "place " + x + ", " + y);
                onPicture += isThere ? 1 : 0;
            }
        }
        assertTrue(onPicture > 450 * Math.min(350, 63 * height), onPicture + " places show the picture");
    }

    /** However thin the picture is in the window, there is something to see. */
    @ParameterizedTest(name = "{0} x {1}")
    @CsvSource({"1000000, 1, 0, 199", "60000, 1000, 0, 196"})
    void thinPicturesAreSeenAsAWhole(int width, int height, int x, int y) {
        BufferedImage image = painted(view(new ShownPicture(Region.whole(width, height))));
        assertNotEquals(PictureView.SURROUNDINGS.getRGB(), image.getRGB(x, y));
    }
}
