package raytracing.timed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import raytracing.SceneText;
import raytracing.Skipped;

class ToPovRayTest {
    private static final List<String> SCENE = List.of(
        "cam 1 2 3  0 0 1  0 1 0  2 0.5",
        "set 0.1 0.2 0.3  4 5",
        "mtl 1 0.5 0.25  0.25 0.5 0.75  0.1 0.2 0.4  30 0.75",
        "sph 1 2 3  4 1",
        "pln 0 2 0  -6 1",
        "box 1 2 3  4 1",
        "lgt 7 8 9  1 1 0.5  1 0.9 2",
        "lgt 7 8 9  1 1 0.5  1 1   0",
        "lgt 7 8 9  1 1 0.5  1 0   2");

    private static String translated() {
        return ToPovRay.of(SceneText.scene(String.join("\n", SCENE)));
    }

    @Test
    void everyObjectHasItsWords() {
        assertEquals(String.join("\n",
            "#version 3.7;",
            "global_settings { assumed_gamma 1 max_trace_level 6 }",
            "background { rgb <0.1, 0.2, 0.3> }",
            "camera { perspective location <1.0, 2.0, 3.0> sky <0.0, 1.0, 0.0> up <0.0, 0.5, 0.0> "
                + "right <0.5, 0.0, 0.0> direction <0.0, 0.0, 2.0> look_at <0.0, 0.0, 1.0> }",
            "light_source { <7.0, 8.0, 9.0> rgb <1.0, 1.0, 0.5> area_light <2.0, 0.0, 0.0>, <0.0, 2.0, 0.0>, 4, 4 "
                + "jitter circular orient }",
            "light_source { <7.0, 8.0, 9.0> rgb <1.0, 1.0, 0.5> }",
            "light_source { <7.0, 8.0, 9.0> rgb <1.0, 1.0, 0.5> shadowless }",
            "#declare M0 = texture { pigment { rgb <1.0, 0.5, 0.25> transmit 0.75 } finish { ambient 0 diffuse 1 "
                + "phong 0.5 phong_size 30.0 reflection { rgb <0.1, 0.2, 0.4> } } }",
            "sphere { <1.0, 2.0, 3.0>, 4.0 texture { M0 } }",
            "plane { <0.0, 2.0, 0.0>, -3.0 texture { M0 } }",
            "box { <-1.0, 0.0, 1.0>, <3.0, 4.0, 5.0> texture { M0 } }",
            ""), translated());
    }

    @Test
    void trianglesOfOneMaterialInARowAreAMesh() {
        List<String> surfaces = List.of("trg 0 0 1  1 0 1  0 1 1  1", "trg 0 0 2  1 0 2  0 1 2  1",
            "trg 0 0 3  1 0 3  0 1 3  2", "sph 1 2 3  4 1", "trg 0 0 4  1 0 4  0 1 4  2");
        String text = ToPovRay.of(SceneText.scene(String.join("\n", SCENE.subList(0, 3)) + "\n" + SCENE.get(2) + "\n"
            + String.join("\n", surfaces)));
        assertEquals(String.join("\n",
            "mesh {",
            "triangle { <0.0, 0.0, 1.0>, <1.0, 0.0, 1.0>, <0.0, 1.0, 1.0> }",
            "triangle { <0.0, 0.0, 2.0>, <1.0, 0.0, 2.0>, <0.0, 1.0, 2.0> }",
            "texture { M0 } }",
            "mesh {",
            "triangle { <0.0, 0.0, 3.0>, <1.0, 0.0, 3.0>, <0.0, 1.0, 3.0> }",
            "texture { M1 } }",
            "sphere { <1.0, 2.0, 3.0>, 4.0 texture { M0 } }",
            "mesh {",
            "triangle { <0.0, 0.0, 4.0>, <1.0, 0.0, 4.0>, <0.0, 1.0, 4.0> }",
            "texture { M1 } }",
            ""), text.substring(text.indexOf("mesh")));
    }

    @Test
    void itsLightsMayHaveMorePointsThanOurs() {
        String text = ToPovRay.of(SceneText.scene(String.join("\n", SCENE)), 17, "jitter adaptive 1");
        assertTrue(text.contains(", 17, 17 jitter adaptive 1 circular orient }"));
    }

    @Test
    void oneShadowRayNeedsNoArea() {
        String hard = String.join("\n", SCENE).replace("4 5", "1 5");
        assertTrue(translated().contains("area_light"));
        assertFalse(ToPovRay.of(SceneText.scene(hard)).contains("area_light"));
    }

    @Test
    void povRayTakesIt(@TempDir Path folder) throws Exception {
        Skipped.unless(isInstalled(), "POV-Ray is not installed; apt-get install -y povray");
        Path file = Files.writeString(folder.resolve("scene.pov"),
            ToPovRay.of(SceneText.scene(String.join("\n", SCENE) + "\ntrg 0 0 1  1 0 1  0 1 1  1")));
        Path picture = folder.resolve("picture.png");
        Path output = folder.resolve("output");
        Process povRay = new ProcessBuilder("povray", "+I" + file, "+O" + picture, "+W20", "+H20", "-A", "-D", "-V")
            .redirectErrorStream(true).redirectOutput(output.toFile()).start();
        assertEquals(0, povRay.waitFor(), Files.readString(output));
        assertTrue(Files.size(picture) > 0);
    }

    private static boolean isInstalled() {
        try {
            return new ProcessBuilder("povray", "--version").redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD).start().waitFor() == 0;
        } catch (IOException missing) {
            return false;
        } catch (InterruptedException request) {
            throw new IllegalStateException(request);
        }
    }
}
