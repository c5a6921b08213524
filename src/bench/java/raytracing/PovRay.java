package raytracing;

import java.awt.image.BufferedImage;
import java.awt.image.Raster;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import raytracing.film.Film;

/**
 * The POV-Ray that is installed on this machine.
 *
 * @param version what it calls itself
 */
public record PovRay(String version) {
    public static final String MISSING =
        "POV-Ray is not installed, so ours is measured alone: `apt-get install -y povray`.\n";

    private static final Pattern VERSION = Pattern.compile("POV-Ray \\d\\S*");
    private static final double MILLISECONDS = 1000;
    private static final String SIZE = "500";

    /** The trace is what we call a frame; parsing and photons have lines of their own. */
    private static final Pattern TRACE = Pattern.compile(
        "Trace Time:[^\\n]*\\n\\s*using \\d+ thread\\(s\\) with ([0-9.]+) CPU-seconds");

    public static Optional<PovRay> installed() {
        try {
            Process process = new ProcessBuilder("povray", "--version").redirectErrorStream(true).start();
            String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            Matcher matcher = VERSION.matcher(output);
            return Optional.of(new PovRay(matcher.find() ? matcher.group() : "POV-Ray of unknown version"));
        } catch (IOException noSuchProgram) {
            return Optional.empty();
        }
    }

    /** As many threads as ours uses, no anti-aliasing, no window, no talk. */
    List<String> command(Path scene, Path picture) {
        return List.of("povray", "+I" + scene, "+O" + picture, "+W" + SIZE, "+H" + SIZE, "-A", "-D",
            "+WT" + Runtime.getRuntime().availableProcessors(), "-V");
    }

    /**
     * Draws a square picture in linear light with 16 bits a channel.
     *
     * @param options about the rays of a pixel, such as {@code +AM2 +A0.1}
     * @return the processor time of all threads while it traced rays, in milliseconds
     * @throws IOException if it cannot be run, fails, or does not say that time
     */
    public double draw(Path scene, Path picture, int size, List<String> options) throws IOException {
        List<String> command = new ArrayList<>(List.of("povray", "+I" + scene, "+O" + picture, "+W" + size, "+H" + size,
            "-D", "-V", "+FN16", "File_Gamma=1.0", "+WT" + Runtime.getRuntime().availableProcessors()));
        command.addAll(options);
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        String talk = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        return traceMilliseconds(talk).orElseThrow(() -> new IOException(
            "POV-Ray does not say how long it traced: " + String.join(" ", command) + "\n" + talk));
    }

    /** The processor time of the trace, from what POV-Ray writes when it has ended. */
    public static OptionalDouble traceMilliseconds(String talk) {
        Matcher matcher = TRACE.matcher(talk);
        return matcher.find() ? OptionalDouble.of(MILLISECONDS * Double.parseDouble(matcher.group(1)))
            : OptionalDouble.empty();
    }

    /** The linear light of such a picture. */
    public static Film film(Path picture) throws IOException {
        BufferedImage image = ImageIO.read(picture.toFile());
        Raster raster = image.getRaster();
        double full = (1 << image.getSampleModel().getSampleSize(0)) - 1;
        Film film = new Film(image.getWidth(), image.getHeight());
        for (int y = 0; y < film.height(); y++) {
            for (int x = 0; x < film.width(); x++) {
                film.set(x, y, raster.getSample(x, y, 0) / full, raster.getSample(x, y, 1) / full,
                    raster.getSample(x, y, 2) / full);
            }
        }
        return film;
    }
}
