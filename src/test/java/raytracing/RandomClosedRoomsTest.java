package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import raytracing.shadow.ShadowMethod;

/** 500 closed rooms under a bright sky, with lamps outside: none is lit. */
class RandomClosedRoomsTest {
    private static final int ROOMS_OF_A_KIND = 100;
    private static final List<Integer> SIZES = List.of(21, 31, 32);

    @ParameterizedTest
    @EnumSource
    void noRandomRoomIsLit(RandomRoom.Kind kind) {
        List<String> lit = new ArrayList<>();
        for (int i = 0; i < ROOMS_OF_A_KIND; i++) {
            RandomRoom random = new RandomRoom(kind, i);
            int count = new DarkRoom(random.room(), SIZES.get(i % SIZES.size())).draw("", DarkRoom.LESS_THAN_A_THOUSANDTH,
                i % 5 == 0 ? new ShadowMethod.Exact() : ShadowMethod.OF_THE_SCENE, random.lines());
            if (count > 0) {
                lit.add("\n" + count + " pixels of " + random.room());
            }
        }
        assertEquals(List.of(), lit, lit.size() + " of " + ROOMS_OF_A_KIND + " rooms are lit");
    }
}
