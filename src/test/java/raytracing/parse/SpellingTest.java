package raytracing.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SpellingTest {
    private static final List<String> WORDS = List.of("sph", "pln", "region");

    @ParameterizedTest
    @CsvSource({"sph, sph", "sp, sph", "spph, sph", "spr, sph", "shp, sph", "pnl, pln", "regoin, region", "rigeon, region",
        "ergio, region"})
    void aThirdOfAWordMayBeWrong(String word, String meant) {
        assertEquals(Optional.of(meant), Spelling.nearest(word, WORDS));
    }

    @ParameterizedTest
    @CsvSource({"'', ", "s, ", "hps, ", "box, ", "rigaun, ", "regionregion, "})
    void moreMayNot(String word) {
        assertEquals(Optional.empty(), Spelling.nearest(word, WORDS));
    }

    @Test
    void theFirstOfTheNearestIsMeant() {
        assertEquals(Optional.of("mat"), Spelling.nearest("max", List.of("mat", "mad")));
        assertEquals(Optional.of("max"), Spelling.nearest("max", List.of("mat", "max")));
    }
}
