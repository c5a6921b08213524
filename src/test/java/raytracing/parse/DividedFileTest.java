package raytracing.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.parallel.ForkJoin;
import raytracing.parallel.Preparation;

/** A long file is divided among threads: wherever that is, what comes out is what comes out of one piece. */
class DividedFileTest {
    private static final String CAM = "cam 0 0 -5  0 0 0  0 1 0  1 2\n";
    private static final String SET = "set 0.1 0.2 0.3  4 10  2\n";
    private static final String MTL = "mtl 1 0.5 0  0.1 0.2 0.3  0 0.4 0  30 0\n";
    private static final String LGT = "lgt 7 7 -7  1 1 1  1 1 1\n";
    private static final String SURFACES = """
        sph 0 1 0  1 1
          # a remark
        box 2.5 1e0 0 .5 2   # with a remark
        \u00a0pln\u00a00 1 0  0\u00a01

        trg 0 0 0  1 0 0  0 1 0.5  2
        SPH 3 1 0  1.000000000000000000001 1
        """;

    static Map<String, String> files() {
        return Map.ofEntries(
            Map.entry("in the usual order", CAM + SET + MTL + MTL + LGT + SURFACES),
            Map.entry("surfaces before all else", SURFACES + LGT + MTL + MTL + SET + CAM),
            Map.entry("materials among surfaces", CAM + SET + SURFACES + MTL + SURFACES + LGT + MTL + SURFACES),
            Map.entry("line ends of two bytes", (CAM + SET + MTL + MTL + LGT + SURFACES).replace("\n", "\r\n")),
            Map.entry("line ends of two bytes and a mistake", (CAM + SET + MTL + SURFACES + MTL + "sph\n").replace("\n", "\r\n")),
            Map.entry("line ends of old machines", (CAM + SET + MTL + MTL + LGT + SURFACES).replace("\n", "\r")),
            Map.entry("without a last line end", CAM + SET + MTL + MTL + SURFACES + "sph 1 1 1 1 1"),
            Map.entry("blank lines", CAM + "\n\n" + SET + MTL + "\r\n\r\r" + MTL + SURFACES + "\n\r\n\n" + SURFACES + "\n\n"),
            Map.entry("an end-of-file mark", CAM + SET + MTL + MTL + SURFACES + "\u001a\n"),
            Map.entry("a ball around an eye that comes first", CAM + SET + MTL + SURFACES + "sph 0 0 -5 1 1\n" + MTL),
            Map.entry("a ball around an eye that comes later", SET + MTL + SURFACES + "sph 0 0 -5 1 1\n" + SURFACES + CAM
                + SURFACES + MTL + "box 0 0 -5 1 1\n"),
            Map.entry("a material that nothing uses", CAM + SET + MTL + MTL + MTL + SURFACES),
            Map.entry("a mistake in a surface", CAM + SET + MTL + MTL + SURFACES + "sph 0 1 0 -1 1\n" + SURFACES),
            Map.entry("corners on one line", CAM + SET + MTL + MTL + SURFACES + "trg 0 0 0 1 1 1 2 2 2 1\n" + SURFACES),
            Map.entry("mistakes in many lines", CAM + SET + MTL + (SURFACES + "sph 0 1 0 x 1\nbox 1\nsqh 1 2\n").repeat(9)),
            Map.entry("a material that no line has", CAM + SET + MTL + MTL + SURFACES + "pln 0 1 0 0 7\n" + SURFACES),
            Map.entry("a second camera", CAM + SET + MTL + MTL + SURFACES + CAM + SURFACES),
            Map.entry("no camera", SET + MTL + MTL + SURFACES),
            Map.entry("another kind of file", "solid cube\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"),
            Map.entry("another kind of file with surfaces", "<html><body>\n" + SURFACES),
            Map.entry("bytes that are no text", CAM + SET + MTL + MTL + SURFACES + "\u0000\ufffd\n" + SURFACES),
            Map.entry("nothing", ""));
    }

    static Stream<String> names() {
        return files().keySet().stream().sorted();
    }

    private static String outcome(byte[] bytes, ForkJoin workers, int firstBytes, int bytesOfAPart) {
        try {
            ParsedScene parsed = SceneParser.parse("a.txt", bytes, workers, firstBytes, bytesOfAPart);
            return parsed.scene() + " with warnings " + parsed.warnings();
        } catch (RayTracerException wrong) {
            return String.valueOf(wrong.messages());
        }
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("names")
    void whereAFileIsDividedMakesNoDifference(String file) {
        byte[] bytes = files().get(file).getBytes(StandardCharsets.UTF_8);
        String expected = outcome(bytes, ForkJoin.sequential(), bytes.length, bytes.length);
        for (int part = 1; part <= bytes.length; part++) {
            assertEquals(expected, outcome(bytes, ForkJoin.sequential(), 0, part));
        }
        for (int first = 0; first <= bytes.length; first++) {
            assertEquals(expected, outcome(bytes, ForkJoin.sequential(), first, 60));
        }
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("names")
    void theNumberOfThreadsMakesNoDifference(String file) {
        byte[] bytes = files().get(file).getBytes(StandardCharsets.UTF_8);
        String expected = outcome(bytes, ForkJoin.sequential(), bytes.length, bytes.length);
        for (int threads : new int[] {2, 3, 8}) {
            assertEquals(expected, outcome(bytes, new ForkJoin(threads, new Preparation()), 10, 40));
        }
    }
}
