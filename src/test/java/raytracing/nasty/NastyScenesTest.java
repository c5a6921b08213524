package raytracing.nasty;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

/** The first of the scenes that {@code gradle nastyScenes} draws by the hundred thousand. */
class NastyScenesTest {
    private static final long SCENES = 300;

    @Test
    void everyPixelOfEverySceneIsLight() {
        Map<Long, String> defects = new ConcurrentSkipListMap<>();
        LongStream.rangeClosed(1, SCENES).parallel().forEach(seed ->
            NastyDrawing.defect(NastyScene.of(seed)).ifPresent(defect -> defects.put(seed, defect)));
        assertEquals(Map.of(), defects);
    }

    @Test
    void aSeedNamesOneScene() {
        assertEquals(NastyScene.of(7), NastyScene.of(7));
    }
}
