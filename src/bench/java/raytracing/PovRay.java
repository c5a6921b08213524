package raytracing;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The POV-Ray that is installed on this machine.
 *
 * @param version what it calls itself
 */
record PovRay(String version) {
    static final String MISSING = "POV-Ray is not installed, so ours is measured alone: `apt-get install -y povray`.\n";

    private static final Pattern VERSION = Pattern.compile("POV-Ray \\d\\S*");
    private static final String SIZE = "500";

    static Optional<PovRay> installed() {
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
}
