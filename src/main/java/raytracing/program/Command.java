package raytracing.program;

import java.nio.file.Path;
import java.util.Set;
import raytracing.film.ImageFormat;
import raytracing.render.RenderSettings;

/** What a command line tells the program to do. */
public sealed interface Command {
    /** Print how the program is used. */
    record Help() implements Command {
    }

    /** Print the program's version. */
    record Version() implements Command {
    }

    /**
     * Draw a scene file into a picture file.
     *
     * @param extras the options that change no pixel
     */
    record Draw(Path scene, Path output, ImageFormat format, RenderSettings settings, Set<Option> extras)
            implements Command {
        public boolean wants(Option extra) {
            return extras.contains(extra);
        }
    }
}
