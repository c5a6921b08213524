package raytracing.watch;

import java.io.IOException;

/** Where what the user asked for goes, if it is not a picture. */
public final class StandardOutput {
    private StandardOutput() {
    }

    /**
     * Prints. A closed pipe says nothing by itself.
     *
     * @param text whole lines
     * @throws IOException if it does not arrive
     */
    public static void print(String text) throws IOException {
        System.out.print(text);
        if (System.out.checkError()) {
            throw new IOException("standard output: could not be written");
        }
    }
}
