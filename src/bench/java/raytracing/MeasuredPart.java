package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** The part of a document that a program writes, between two marks; the rest is written by hand. */
final class MeasuredPart {
    private static final String BEGIN = "<!-- measured: begin -->\n";
    private static final String END = "<!-- measured: end -->\n";

    private MeasuredPart() {
    }

    static void replace(Path file, String measured) throws IOException {
        String document = Files.readString(file);
        int begin = document.indexOf(BEGIN);
        int end = document.indexOf(END);
        if (begin < 0 || end < begin) {
            throw new IOException(file + " lacks the marks " + BEGIN + END);
        }
        Files.writeString(file, document.substring(0, begin + BEGIN.length()) + "\n" + measured + "\n"
            + document.substring(end));
    }
}
