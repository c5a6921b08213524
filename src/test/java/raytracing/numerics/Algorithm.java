package raytracing.numerics;

/** A contender: ours, or a witness of what a simpler formula costs. Tests, accuracy table and benchmark share it. */
public interface Algorithm {
    /** Name of the constant. */
    String name();

    /** Short name, for the head of a table. */
    String title();

    /** What it does, in a line. */
    String description();

    /** How it does it. */
    Formula formula();
}
