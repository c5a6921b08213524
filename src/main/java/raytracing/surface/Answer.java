package raytracing.surface;

/** What doubles tell of a question that has an exact answer. */
enum Answer {
    YES,
    NO,

    /** Doubles cannot tell: exact numbers decide. */
    UNDECIDED;

    static Answer of(boolean isYes) {
        return isYes ? YES : NO;
    }
}
