package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import raytracing.parallel.ForkJoin;
import raytracing.parse.SceneParser;
import raytracing.scene.Scene;

class FamilyTest {
    private static Scene scene(int root, String light) throws Exception {
        return SceneParser.parse("made", """
            cam 0 0 -5  0 0 0  0 1 0  1 1
            set 0 0 0  %d 1
            mtl 1 1 1  0 0 0  0 0 0  1 0
            sph 0 0 0  1  1
            %s
            """.formatted(root, light).getBytes(StandardCharsets.UTF_8), ForkJoin.sequential()).scene();
    }

    @Test
    void onlyWideLightsWithShadowsMakeSoftOnes() throws Exception {
        assertTrue(Family.SHADOWS.concerns(scene(1, "lgt 0 9 0  1 1 1  1  1  2")));
        assertFalse(Family.SHADOWS.concerns(scene(4, "lgt 0 9 0  1 1 1  1  1  0")));
        assertFalse(Family.SHADOWS.concerns(scene(4, "lgt 0 9 0  1 1 1  1  0  2")));
        assertTrue(Family.EDGES.concerns(scene(1, "lgt 0 9 0  1 1 1  1  1  0")));
    }

    @Test
    void theScenesOwnRootIsMeasuredAmongTheOthers() throws Exception {
        List<Double> roots = Family.SHADOWS.settings(scene(20, ""), Budget.OF_MANY).stream()
            .filter(setting -> setting.series() == Series.SAMPLED).map(Setting::number).toList();
        assertEquals(List.of(1.0, 2.0, 4.0, 8.0, 16.0, 20.0), roots);
    }

    @Test
    void settingsAreAskedForInWords() {
        assertEquals(Optional.of(List.of("--shadows", "sampled", "--shadow-rays", "7")), Setting.sampled(7).options());
        assertEquals(Optional.of(List.of("--shadows", "exact", "--samples", "4")), Setting.atEdges(4).options());
        assertEquals(Optional.of(List.of("--error", "0.5")), Setting.errorLimit(0.5).options());
        assertEquals(Optional.of(List.of("--error", "16")), Setting.errorLimit(16).options());
        assertEquals(Optional.empty(), Setting.everywhere(4).options());
    }
}
