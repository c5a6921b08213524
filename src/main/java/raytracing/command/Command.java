package raytracing.command;

import java.nio.file.Path;
import java.util.Set;
import raytracing.film.ImageFormat;
import raytracing.render.RenderSettings;

/** What the user asks the program to do. */
public sealed interface Command {
    /** Print how the program is used. */
    record Help() implements Command {
    }

    /** Print which program this is. */
    record Version() implements Command {
    }

    /**
     * Draw a scene.
     *
     * @param scene the scene file
     * @param output the picture file
     * @param format what to write into it
     * @param settings how to draw
     * @param extras what is wanted beside the picture
     */
    record Draw(Path scene, Path output, ImageFormat format, RenderSettings settings, Set<Extra> extras)
            implements Command {
        /**
         * Whether something is wanted.
         *
         * @param extra beside the picture
         * @return true if it is
         */
        public boolean wants(Extra extra) {
            return extras.contains(extra);
        }
    }
}
