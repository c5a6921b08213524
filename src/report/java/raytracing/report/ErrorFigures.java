package raytracing.report;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import raytracing.Films;
import raytracing.PictureDifference;
import raytracing.film.Film;
import raytracing.render.Region;

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
    /** Where there is a reference. */
    static ErrorFigures of(Film found, Reference reference) {
        List<ErrorFigures> figures = new ArrayList<>();
        for (int i = 0; i < reference.blocks().size(); i++) {
            Region block = reference.blocks().get(i);
            figures.add(of(found.part(block.left(), block.top(), block.width(), block.height()),
                reference.films().get(i)));
        }
        return ofAll(figures);
    }

    static ErrorFigures of(Film found, Film reference) {
        BufferedImage picture = found.toImage();
        BufferedImage aim = reference.toImage();
        PictureDifference difference = new PictureDifference(picture, aim);
        return new ErrorFigures(Films.rootMeanSquare(found, reference), Films.largest(found, reference),
            difference.psnr(), difference.shareOffByMoreThan(1), Ssim.mean(picture, aim));
    }

    /** Of parts of the same size together; no window of the similarity crosses from one to another. */
    static ErrorFigures ofAll(List<ErrorFigures> parts) {
        return new ErrorFigures(
            Math.sqrt(mean(parts, part -> part.rootMeanSquare * part.rootMeanSquare)),
            parts.stream().mapToDouble(ErrorFigures::largest).max().orElseThrow(),
            -10 * Math.log10(mean(parts, part -> Math.pow(10, -part.psnr / 10))),
            mean(parts, ErrorFigures::shareOff), mean(parts, ErrorFigures::ssim));
    }

    private static double mean(List<ErrorFigures> parts, ToDoubleFunction<ErrorFigures> figure) {
        return parts.stream().mapToDouble(figure).average().orElseThrow();
    }
}
