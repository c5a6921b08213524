package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** The part of a document that a program writes, between two marks; the rest is written by hand. */
public final class MeasuredPart {
    private static final String BEGIN = "<!-- measured: begin -->\n";
    private static final String END = "<!-- measured: end -->\n";

    private MeasuredPart() {
    }

    /** Writes another one in its place. */
    public static void replace(Path file, String measured) throws IOException {
        String document = Files.readString(file);
        Files.writeString(file, document.substring(0, begin(file, document)) + "\n" + measured + "\n"
            + document.substring(document.indexOf(END)));
    }

    /** What was written last. */
    public static String of(Path file) throws IOException {
        String document = Files.readString(file);
        return document.substring(begin(file, document), document.indexOf(END)).strip();
    }

    private static int begin(Path file, String document) throws IOException {
        int begin = document.indexOf(BEGIN);
        if (begin < 0 || document.indexOf(END) < begin) {
            throw new IOException(file + " lacks the marks " + BEGIN + END);
        }
        return begin + BEGIN.length();
    }
}
