package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A picture of two tiles, of which one thread draws the upper one at once and the lower one never: half of it is done, on
 * every machine, for as long as a test needs that.
 */
final class Endless {
    static final int WIDTH = 16;
    static final int HEIGHT = 32;
    static final int BACKGROUND = 0xff4080ff;

    /**
     * The eye looks at the horizon. A ball in the middle of the lamps, above what is seen, hides some of each from every
     * point of the floor, which takes a million shadow rays to each of a thousand lamps for that: hours for a tile.
     */
    private static final String SCENE = """
        cam 0 1 -3   0 1 0   0 1 0   1 1
        set 0.25 0.5 1   1024 4
        mtl 0.5 0.5 0.5   0 0 0   0 0 0   1 0
        pln 0 1 0  0  1
        sph 0 9 0  3  1
        """ + "lgt 0 9 0   1 1 1   1 1 20\n".repeat(1000);

    private Endless() {
    }

    /** Writes the scene into a folder; the program's arguments that draw it there. */
    static String arguments(Path folder, String output) throws IOException {
        Files.writeString(folder.resolve("endless.txt"), SCENE);
        return "endless.txt " + output + " " + WIDTH + " " + HEIGHT + " --threads 1";
    }
}
