package raytracing.parse;

import java.util.ArrayList;
import java.util.List;

/** What the user gave is wrong: a scene or a command. Each message is a sentence of one line that says what to mend. */
public final class RayTracerException extends Exception {
    private static final long serialVersionUID = 1;

    private final transient List<String> messages;

    /**
     * Several things are wrong.
     *
     * @param messages one line each, at least one; what could not be seen in them is shown as {@link Printable} does
     */
    public RayTracerException(List<String> messages) {
        super(String.join(System.lineSeparator(), printable(messages)));
        this.messages = List.copyOf(printable(messages));
    }

    /**
     * One thing is wrong.
     *
     * @param message one line
     */
    public RayTracerException(String message) {
        this(List.of(message));
    }

    private static List<String> printable(List<String> messages) {
        List<String> printable = new ArrayList<>();
        for (String message : messages) {
            printable.add(Printable.of(message));
        }
        return printable;
    }

    /**
     * What is wrong.
     *
     * @return one line each, at least one
     */
    public List<String> messages() {
        return messages;
    }
}
