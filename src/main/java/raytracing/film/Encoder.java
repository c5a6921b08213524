package raytracing.film;

import java.io.IOException;
import java.io.OutputStream;

/** A picture that is going to be a file of some format. What it needs of the picture before the file may exist is drawn. */
interface Encoder {
    /**
     * Writes the whole file, once, and leaves the stream open. An exception of a band is thrown on.
     *
     * @throws IOException if the stream takes no more
     */
    void writeTo(OutputStream file) throws IOException;
}
