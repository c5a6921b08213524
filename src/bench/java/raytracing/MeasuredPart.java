package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** The part of a document that a program writes, between two marks; the rest is written by hand. */
public final class MeasuredPart {
    private static final String USUAL = "measured";

    private MeasuredPart() {
    }

    /** Writes another one in its place. */
    public static void replace(Path file, String measured) throws IOException {
        replace(file, USUAL, measured);
    }

    /** Writes another one in its place, in a document with several such parts: the marks bear its name. */
    public static void replace(Path file, String name, String measured) throws IOException {
        String document = Files.readString(file);
        Files.writeString(file, document.substring(0, begin(file, document, name)) + "\n" + measured + "\n"
            + document.substring(document.indexOf(mark(name, "end"))));
    }

    /** What was written last. */
    public static String of(Path file) throws IOException {
        String document = Files.readString(file);
        return document.substring(begin(file, document, USUAL), document.indexOf(mark(USUAL, "end"))).strip();
    }

    private static String mark(String name, String which) {
        return "<!-- " + name + ": " + which + " -->\n";
    }

    private static int begin(Path file, String document, String name) throws IOException {
        String mark = mark(name, "begin");
        int begin = document.indexOf(mark);
        if (begin < 0 || document.indexOf(mark(name, "end")) < begin) {
            throw new IOException(file + " lacks the marks " + mark + mark(name, "end"));
        }
        return begin + mark.length();
    }
}
