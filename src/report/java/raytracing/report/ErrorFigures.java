package raytracing.report;

import java.awt.image.BufferedImage;
import raytracing.Films;
import raytracing.PictureDifference;
import raytracing.film.Film;

/**
 * How far a picture is from its reference.
 *
 * @param rootMeanSquare over all channels of all pixels, in linear light
 * @param largest difference of a channel of a pixel, in linear light
 * @param psnr of the 8-bit pictures, in decibels; infinite where they are equal
 * @param shareOff share of pixels of which a channel differs by more than one of the 255 steps
 * @param ssim mean structural similarity of the 8-bit pictures
 */
record ErrorFigures(double rootMeanSquare, double largest, double psnr, double shareOff, double ssim) {
    static ErrorFigures of(Film found, Film reference) {
        BufferedImage picture = found.toImage();
        BufferedImage aim = reference.toImage();
        PictureDifference difference = new PictureDifference(picture, aim);
        return new ErrorFigures(Films.rootMeanSquare(found, reference), Films.largest(found, reference),
            difference.psnr(), difference.shareOffByMoreThan(1), Ssim.mean(picture, aim));
    }
}
