package raytracing;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.scene.Camera;

/** How much a ray has in common with the one before it. */
public enum Coherence {
    /** Nearest: from the eye, pixel after pixel. Occluded: from what these meet to the first lamp. */
    COHERENT,

    /**
     * Nearest: from what the eye's rays meet, in any order, anywhere on the seen side. Occluded: from there to any
     * point of a sphere around the scene.
     */
    INCOHERENT;

    private static final long SEED = 23;

    /** The directions from a camera through the pixels of a small square picture, row by row, as a pinhole has them. */
    static List<Vector> throughPixels(Camera camera, int size) {
        Vector rightAxis = camera.right();
        Vector forwardAxis = camera.forward();
        Vector upAxis = forwardAxis.cross(rightAxis);
        List<Vector> directions = new ArrayList<>();
        for (int y = 0; y < size; y++) {
            for (int x = 0; x < size; x++) {
                double right = ((x + 0.5) / size - 0.5) * camera.screenWidth();
                double up = (0.5 - (y + 0.5) / size) * camera.screenWidth();
                Vector ahead = forwardAxis.times(camera.screenDistance());
                directions.add(Vectors.plus(Vectors.plus(ahead, right, rightAxis), up, upAxis).unit());
            }
        }
        return directions;
    }

    /** The same things in an order that says nothing about the next. */
    static <T> List<T> shuffled(List<T> things) {
        List<T> shuffled = new ArrayList<>(things);
        Collections.shuffle(shuffled, new Random(SEED));
        return shuffled;
    }

    /** Directions that are spread evenly over the sphere. */
    static List<Vector> anywhere(int count) {
        Random random = new Random(SEED);
        List<Vector> directions = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            directions.add(new Vector(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit());
        }
        return directions;
    }
}
