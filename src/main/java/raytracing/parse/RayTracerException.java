package raytracing.parse;

import java.util.List;

/** A scene or a command of the user is wrong. Each message is one line that says what to correct. */
public final class RayTracerException extends Exception {
    private static final long serialVersionUID = 1;

    private final transient List<String> messages;

    /** Takes at least one message; {@link Printable} shows what would be invisible in them. */
    public RayTracerException(List<String> messages) {
        super(String.join(System.lineSeparator(), printable(messages)));
        this.messages = printable(messages);
    }

    public RayTracerException(String message) {
        this(List.of(message));
    }

    private static List<String> printable(List<String> messages) {
        return messages.stream().map(Printable::of).toList();
    }

    /** At least one message, each one line. */
    public List<String> messages() {
        return messages;
    }
}
