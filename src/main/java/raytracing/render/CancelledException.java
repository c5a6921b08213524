package raytracing.render;

/** There is no picture, because its drawing was cancelled. */
public final class CancelledException extends RuntimeException {
    private static final long serialVersionUID = 1;

    public CancelledException() {
        super("cancelled");
    }
}
