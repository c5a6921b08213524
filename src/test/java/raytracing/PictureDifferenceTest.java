package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;

class PictureDifferenceTest {
    private static BufferedImage picture(int... colors) {
        BufferedImage picture = new BufferedImage(colors.length, 1, BufferedImage.TYPE_INT_RGB);
        picture.setRGB(0, 0, colors.length, 1, colors, 0, colors.length);
        return picture;
    }

    @Test
    void equalPicturesDoNotDiffer() {
        PictureDifference none = new PictureDifference(picture(0x123456), picture(0x123456));
        assertEquals(Double.POSITIVE_INFINITY, none.psnr());
        assertEquals(0, none.mean());
        assertEquals(0, none.rootMeanSquare());
        assertEquals(0, none.largest());
        assertEquals(0, none.shareOffByMoreThan(0));
    }

    /** One of six channels is off by 6: mean square 6, mean 1. */
    @Test
    void figuresAreThoseWorkedOutByHand() {
        PictureDifference one = new PictureDifference(picture(0x000600, 0xffffff), picture(0x000000, 0xffffff));
        assertEquals(10 * Math.log10(255 * 255 / 6.0), one.psnr(), 1e-12);
        assertEquals(1, one.mean());
        assertEquals(Math.sqrt(6), one.rootMeanSquare(), 1e-12);
        assertEquals(6, one.largest());
        assertEquals(0.5, one.shareOffByMoreThan(5));
        assertEquals(0, one.shareOffByMoreThan(6));
    }
}
