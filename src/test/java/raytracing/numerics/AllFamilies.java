package raytracing.numerics;

import java.util.stream.Stream;
import org.junit.jupiter.api.Named;

/** Every family of every shape, named for a report. */
final class AllFamilies {
    /** For {@code @MethodSource}. */
    static final String NAMED = "raytracing.numerics.AllFamilies#named";

    private AllFamilies() {
    }

    static Stream<Named<Family>> named() {
        return Stream.of(Shape.values()).flatMap(shape -> shape.families().stream())
            .map(family -> Named.of(family.shape() + " " + family.title(), family));
    }
}
