package raytracing.report;

import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.image.BufferedImage;
import java.util.Optional;
import raytracing.film.Film;

/**
 * What is shown of a picture: films of all of them would not fit into memory.
 *
 * @param picture in 8 bits, as large as a page shows it
 * @param errorMap its errors in false colours, where all of the picture is compared
 * @param closeup where it is worst
 * @param pictureSize width of the drawn picture in pixels, for the close-up's place in it
 */
record Illustration(BufferedImage picture, Optional<BufferedImage> errorMap, Closeup closeup, int pictureSize) {
    static Illustration of(Film film, Reference reference, int shownEdge) {
        Optional<BufferedImage> map = reference.whole().map(aim -> ErrorMap.of(film, aim));
        return new Illustration(scaled(film.toImage(), shownEdge), map.map(image -> scaled(image, shownEdge)),
            Closeup.of(film, reference), film.width());
    }

    /** A square picture, not larger than so many pixels: each shows the mean of those it stands for. */
    static BufferedImage scaled(BufferedImage picture, int edge) {
        if (picture.getWidth() <= edge) {
            return picture;
        }
        BufferedImage scaled = new BufferedImage(edge, edge, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = scaled.createGraphics();
        graphics.drawImage(picture.getScaledInstance(edge, edge, Image.SCALE_AREA_AVERAGING), 0, 0, null);
        graphics.dispose();
        return scaled;
    }
}
