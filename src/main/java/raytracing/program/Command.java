package raytracing.program;

import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import raytracing.film.ImageFile;
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
     * @param extras the options without a value that change no pixel
     * @param compare what to compare the picture with, if anything
     */
    record Draw(Path scene, Path output, ImageFormat format, RenderSettings settings, Set<Option> extras,
                Optional<Compare> compare) implements Command {
        public boolean wants(Option extra) {
            return extras.contains(extra);
        }
    }

    /** Compare the finished picture with that of a file, and draw a map of the differences if there is a file for it. */
    record Compare(Path file, Optional<ImageFile> map) {
    }
}
