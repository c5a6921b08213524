package raytracing.timed;

import java.util.OptionalDouble;

/**
 * What a whole process took.
 *
 * @param wallSeconds from its start to its end
 * @param cpuSeconds of all its threads, in the program and in the system; empty if it is not known
 * @param peakMebibytes most memory that it held at once; empty if it is not known
 */
public record ProcessCost(double wallSeconds, OptionalDouble cpuSeconds, OptionalDouble peakMebibytes) {
    /** What {@link #of} reads: user seconds, system seconds, kibibytes. */
    public static final String TIME_FORMAT = "%U %S %M";

    private static final double KIBIBYTES = 1024;

    /** Nothing but the clock. */
    public static ProcessCost of(double wallSeconds) {
        return new ProcessCost(wallSeconds, OptionalDouble.empty(), OptionalDouble.empty());
    }

    /** The clock, and a line that GNU time wrote in {@link #TIME_FORMAT}. */
    public static ProcessCost of(double wallSeconds, String line) {
        String[] words = line.strip().split(" ");
        return new ProcessCost(wallSeconds,
            OptionalDouble.of(Double.parseDouble(words[0]) + Double.parseDouble(words[1])),
            OptionalDouble.of(Double.parseDouble(words[2]) / KIBIBYTES));
    }
}
