package raytracing.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import raytracing.Films;
import raytracing.PovRay;
import raytracing.scene.Scene;
import raytracing.timed.ToPovRay;

/**
 * POV-Ray's trace of a scene.
 *
 * @param povRay that is installed
 * @param title on the plot
 * @param scene in our words
 * @param place how its file and its picture are named, without an ending
 * @param size of the picture, in pixels
 * @param rays n of the n x n pixels that are drawn for each pixel of the picture, which gets their mean
 * @param lightRoot N of N x N points on each wide light
 * @param lightMethod what else is said of those points
 * @param options of the command line, about the rays of a pixel
 */
record PovRayContender(PovRay povRay, String title, Scene scene, Path place, int size, int rays, int lightRoot,
                       String lightMethod, List<String> options) implements Contender {
    @Override
    public Drawn draw() throws IOException {
        Path file = Path.of(place + ".pov");
        Path picture = Path.of(place + ".png");
        Files.writeString(file, ToPovRay.of(scene, lightRoot, lightMethod));
        double milliseconds = povRay.draw(file, picture, size * rays, options);
        return new Drawn(Films.shrunk(PovRay.film(picture), rays), milliseconds);
    }
}
