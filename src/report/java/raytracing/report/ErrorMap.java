package raytracing.report;

import java.awt.image.BufferedImage;
import raytracing.Films;
import raytracing.film.Film;

/** Where a picture is wrong: the absolute error of each pixel's worst channel, in linear light and false colours. */
final class ErrorMap {
    private ErrorMap() {
    }

    static BufferedImage of(Film found, Film reference) {
        BufferedImage map = new BufferedImage(found.width(), found.height(), BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < found.height(); y++) {
            for (int x = 0; x < found.width(); x++) {
                map.setRGB(x, y, ColorScale.color(Films.largestOfPixel(found.get(x, y), reference.get(x, y))));
            }
        }
        return map;
    }
}
