package raytracing.report;

import java.util.OptionalDouble;
import raytracing.Machine;

/**
 * How busy the machine was: the load of its last minute, in processors.
 *
 * @param before the measurement began: what other programs did
 * @param after it had ended; it is part of that itself
 * @param processors of the machine
 */
record MachineLoad(OptionalDouble before, OptionalDouble after, int processors) {
    /** A machine with more to do than this share of it is not quiet. */
    private static final double QUIET = 0.25;

    /** Of a measurement that has just ended. */
    static MachineLoad since(OptionalDouble before) {
        return new MachineLoad(before, Machine.load(), Runtime.getRuntime().availableProcessors());
    }

    String sentences() {
        if (before.isEmpty() || after.isEmpty()) {
            return "The system does not say how busy the machine was.";
        }
        return "Load of the machine: " + Shown.rough(before.getAsDouble()) + " before and "
            + Shown.rough(after.getAsDouble()) + " after; the measurement alone makes " + processors + "."
            + (before.getAsDouble() > QUIET * processors
                ? " Other programs were running: times are too long, ratios of times less so." : "");
    }
}
