package raytracing.command;

import java.nio.file.Path;
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
     */
    record Draw(Path scene, Path output, ImageFormat format, RenderSettings settings) implements Command {
    }
}
