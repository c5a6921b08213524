package raytracing.fuzz;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Inputs that the fuzzer found worth keeping: together they reach every branch of the parser that it reached. One file
 * holds them, an input in each line, so that a reader sees what they are: everything but printable ASCII is escaped, as
 * {@code \n}, {@code \\} or {@code \xff}.
 */
public final class Corpus {
    /** Where the file is in the sources, from the project's folder. */
    public static final Path SOURCE = Path.of("src/test/resources/raytracing/fuzz/corpus.txt");

    private static final String RESOURCE = "corpus.txt";
    private static final int HEXADECIMAL = 16;

    private Corpus() {
    }

    /**
     * All inputs that are kept.
     *
     * @return the bytes of each
     */
    public static List<byte[]> inputs() {
        try (InputStream file = Corpus.class.getResourceAsStream(RESOURCE)) {
            List<byte[]> inputs = new ArrayList<>();
            for (String line : new String(file.readAllBytes(), StandardCharsets.US_ASCII).split("\n")) {
                inputs.add(bytes(line));
            }
            return inputs;
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    /**
     * Keeps other inputs instead.
     *
     * @param inputs the bytes of each
     * @throws IOException if the file cannot be written
     */
    public static void keep(List<byte[]> inputs) throws IOException {
        Files.createDirectories(SOURCE.getParent());
        StringBuilder lines = new StringBuilder();
        inputs.forEach(input -> lines.append(line(input)).append('\n'));
        Files.writeString(SOURCE, lines, StandardCharsets.US_ASCII);
    }

    /** Bytes as they stand in the file. */
    static String line(byte[] bytes) {
        StringBuilder line = new StringBuilder();
        for (byte b : bytes) {
            if (b == '\n') {
                line.append("\\n");
            } else if (b == '\\') {
                line.append("\\\\");
            } else if (b >= ' ' && b <= '~') {
                line.append((char) b);
            } else {
                line.append(String.format("\\x%02x", b));
            }
        }
        return line.toString();
    }

    /** The bytes of a line of the file. */
    static byte[] bytes(String line) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        for (int i = 0; i < line.length(); i++) {
            char c = line.charAt(i);
            if (c != '\\') {
                bytes.write(c);
            } else if (line.charAt(++i) == 'x') {
                bytes.write(Integer.parseInt(line.substring(i + 1, i + 3), HEXADECIMAL));
                i += 2;
            } else {
                bytes.write(line.charAt(i) == 'n' ? '\n' : '\\');
            }
        }
        return bytes.toByteArray();
    }
}
