package raytracing;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;

/** A screen in memory: an X server that keeps its pixels in a file, which is read instead of taking a screenshot. */
final class VirtualScreen implements AutoCloseable {
    /** Places of numbers in the header of an X window dump, all with the highest byte first. */
    private static final int HEADER_SIZE = 0;
    private static final int WIDTH = 16;
    private static final int HEIGHT = 20;
    private static final int BYTES_IN_A_LINE = 48;
    private static final int COLOURS = 76;
    private static final int BYTES_IN_A_COLOUR = 12;

    /** The file that a Java has if it can open windows. */
    static final Path WINDOWS = Path.of("lib/libawt_xawt.so");

    private final Process server;
    private final Path pixels;
    private final String name;

    private VirtualScreen(Process server, Path pixels, String name) {
        this.server = server;
        this.pixels = pixels;
        this.name = name;
    }

    /** Whether a Java can open windows at all. */
    static boolean isOpenTo(Path javaHome) {
        return Files.exists(javaHome.resolve(WINDOWS));
    }

    /** On a free display, with its files in a folder; skips the calling test where that is impossible. */
    static VirtualScreen start(Path folder) throws IOException, InterruptedException {
        Skipped.unless(isOpenTo(Program.JAVA_HOME), "no window is tested without a Java that has windows");
        Skipped.unless(Shell.has("Xvfb"), "no window is tested without Xvfb");
        Path number = folder.resolve("display");
        Process server = new ProcessBuilder("Xvfb", "-displayfd", "1", "-screen", "0", "1280x1024x24", "-nocursor",
            "-nolisten", "tcp",
            "-fbdir", folder.toString()).redirectOutput(number.toFile()).redirectError(ProcessBuilder.Redirect.DISCARD).start();
        try {
            Patience.await("virtual screen", () -> Files.readString(number).endsWith("\n"));
            return new VirtualScreen(server, folder.resolve("Xvfb_screen0"), ":" + Files.readString(number).strip());
        } catch (IOException | InterruptedException | AssertionError failure) {
            server.destroyForcibly();
            throw failure;
        }
    }

    /** Its value for DISPLAY. */
    String name() {
        return name;
    }

    /** The pixels that it shows now. */
    BufferedImage screenshot() throws IOException {
        ByteBuffer dump = ByteBuffer.wrap(Files.readAllBytes(pixels));
        int start = dump.getInt(HEADER_SIZE) + BYTES_IN_A_COLOUR * dump.getInt(COLOURS);
        BufferedImage image = new BufferedImage(dump.getInt(WIDTH), dump.getInt(HEIGHT), BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                image.setRGB(x, y, Integer.reverseBytes(dump.getInt(start + y * dump.getInt(BYTES_IN_A_LINE) + 4 * x)));
            }
        }
        return image;
    }

    @Override
    public void close() {
        server.destroy();
        server.onExit().completeOnTimeout(server, Patience.LIMIT.toMinutes(), TimeUnit.MINUTES).join();
        server.destroyForcibly();
    }
}
