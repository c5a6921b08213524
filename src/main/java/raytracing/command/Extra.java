package raytracing.command;

/** What the user may want beside the picture; none of it changes a pixel. */
public enum Extra {
    /** No messages but errors. */
    QUIET,

    /** A window that shows the picture while it is drawn. */
    PREVIEW,

    /** The same, and another picture whenever the scene file is saved, until the window is closed. */
    WATCH,

    /** What the picture took, to be read by people. */
    STATISTICS,

    /** What the picture took, to be read by programs. */
    STATISTICS_AS_JSON,

    /** What is finished when the program is stopped, instead of the older file. */
    KEEP_PARTIAL
}
