package raytracing.parse;

import java.util.List;

/** What the user gave is wrong: a scene or a command. Each message is a sentence of one line that says what to mend. */
public final class RayTracerException extends Exception {
    private static final long serialVersionUID = 1;

    private final transient List<String> messages;

    /**
     * Several things are wrong.
     *
     * @param messages one line each, at least one
     */
    public RayTracerException(List<String> messages) {
        super(String.join(System.lineSeparator(), messages));
        this.messages = List.copyOf(messages);
    }

    /**
     * One thing is wrong.
     *
     * @param message one line
     */
    public RayTracerException(String message) {
        this(List.of(message));
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
