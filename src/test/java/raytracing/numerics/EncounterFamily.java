package raytracing.numerics;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.stream.Stream;

/** Random rays that meet several surfaces at the same place or nearly so. */
interface EncounterFamily {
    /** Name of the constant. */
    String name();

    /** In words, for a table. */
    String title();

    /** How its encounters are drawn. */
    Function<RandomNumbers, Encounter> recipe();

    /** The same encounters for the same seed on every machine, their rays all well off all surfaces. */
    default List<Encounter> encounters(long seed, int count) {
        RandomNumbers random = new RandomNumbers(new SplittableRandom(seed));
        return Stream.generate(() -> recipe().apply(random)).filter(Encounter::startsWellOff).limit(count).toList();
    }
}
