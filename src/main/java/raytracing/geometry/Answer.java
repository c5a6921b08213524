package raytracing.geometry;

/** What doubles can say about a question whose answer is yes or no. */
public enum Answer {
    /** Yes, whatever was rounded. */
    YES,

    /** No, whatever was rounded. */
    NO,

    /** The error bound leaves it open, or a point is on a surface as far as it is known: exact numbers decide. */
    UNDECIDED
}
