package raytracing.numerics;

import java.util.SplittableRandom;

/**
 * Random queries that are hard for one reason, or ordinary. Ordinary rays meet many surfaces in a row, as in a scene,
 * about half of which they hit; a hard ray has a surface of its own.
 */
public interface Family {
    /** Name of the constant. */
    String name();

    /** Which kind of surface its rays meet. */
    Shape shape();

    /** In words, for the head of a table. */
    String title();

    /** How its queries are drawn. */
    Recipe recipe();

    /** The same queries for the same seed on every machine. */
    default Queries queries(long seed, int count) {
        return Queries.drawn(recipe(), new RandomNumbers(new SplittableRandom(seed)), count);
    }

    /** The same with their exact answers. */
    default Sample sample(long seed, int count) {
        return Sample.of(shape(), queries(seed, count));
    }

    /**
     * First a ray, then its surfaces.
     *
     * @param surfacesPerRay how many surfaces each ray meets
     * @param line draws a ray
     * @param surface draws a surface for that ray
     */
    record Recipe(int surfacesPerRay, LineSource line, SurfaceSource surface) {
    }

    /** Draws rays. */
    @FunctionalInterface
    interface LineSource {
        Line draw(RandomNumbers random);
    }

    /** Draws surfaces for a given ray; where it changes the ray's direction, it is the only surface of that ray. */
    @FunctionalInterface
    interface SurfaceSource {
        Query draw(RandomNumbers random, Line line);
    }
}
