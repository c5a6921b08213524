package raytracing.render;

/** There is no picture, because somebody asked for that. */
public final class CancelledException extends RuntimeException {
    private static final long serialVersionUID = 1;

    CancelledException() {
        super("cancelled");
    }
}
