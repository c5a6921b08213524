package raytracing.program;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import raytracing.parse.Printable;
import raytracing.parse.RayTracerException;

/** What the user reads when something fails. */
public final class Failures {
    private static final long GIGABYTE = 1L << 30;

    private Failures() {
    }

    /** The sentences about a failure, at least one. */
    public static List<String> messages(Throwable failure) {
        if (failure instanceof RayTracerException wrong) {
            return wrong.messages();
        }
        if (failure instanceof IOException notReadOrWritten) {
            String name = failure instanceof FileSystemException file && file.getFile() != null ? file.getFile() + ": " : "";
            return List.of(Printable.of(name + reason(notReadOrWritten)));
        }
        return List.of(failure instanceof OutOfMemoryError shortage ? shortage(shortage)
            : "this is a defect of the program, please report it: " + failure);
    }

    /** The error to throw if a picture file cannot be written; its message says what the file contains now. */
    static IOException notWritten(Path file, IOException failure) {
        return new IOException(file + ": could not be written: " + reason(failure) + "; the file is as it was");
    }

    /** Virtual machines throw the same error if the system allows no more threads. */
    private static String shortage(OutOfMemoryError error) {
        if (String.valueOf(error.getMessage()).contains("thread")) {
            return "the system allows no more threads; --threads 1 needs the fewest";
        }
        long allowed = (Runtime.getRuntime().maxMemory() - 1) / GIGABYTE + 1;
        long more = Math.max(4, 2 * allowed);
        return "not enough memory for this scene and picture size; java -Xmx" + more + "g -jar RayTracer.jar ... allows "
            + more + " GB";
    }

    /**
     * What is wrong with a file, without its name. Looks for the first cause: the outer message is often that of a library, or
     * the file's name alone.
     */
    static String reason(IOException thrown) {
        IOException failure = thrown;
        while (failure.getCause() instanceof IOException cause) {
            failure = cause;
        }
        String reason = failure instanceof FileSystemException file && file.getFile() != null
            ? file.getReason() : failure.getMessage();
        return reason == null ? kind(failure) : reason;
    }

    /** {@code AccessDeniedException} becomes "access denied". */
    private static String kind(IOException failure) {
        String name = failure.getClass().getSimpleName().replace("Exception", "");
        return name.replaceAll("(?<=.)(?=[A-Z])", " ").toLowerCase(Locale.ROOT);
    }
}
