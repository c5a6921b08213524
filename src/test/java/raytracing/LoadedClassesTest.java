package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A small picture takes hardly longer than the start of a virtual machine: only what is needed for it is loaded. */
class LoadedClassesTest {
    /** Each of them loads dozens of others: what makes lambdas and the methods of records, texts by patterns, and pictures. */
    private static final Pattern COSTLY = Pattern.compile("java\\.lang\\.runtime\\.|LambdaMetafactory|Lambda\\$|"
        + "LambdaForm\\$\\w*MH|java\\.util\\.Formatter|java\\.util\\.regex\\.|java\\.util\\.stream\\.|java\\.awt\\.|javax\\.");
    private static final Pattern CLASS = Pattern.compile("(?m)\\] (\\S+) source: ");

    /** Surfaces of every kind, each twice in the same place, transparent and mirroring, in ambient light, with soft shadows. */
    private static final String SCENE = """
        cam 0 0.2 -2.8  0 0 0  0 1 0  1 1
        set 0.2 0.3 0.4  3 4
        mtl 0.9 0.5 0.4  0.3 0.3 0.3  0.2 0.2 0.2  10 0.3  0.2 0.2 0.2
        pln 0 1 0 -1 1
        pln 0 1 0 -1 1
        pln 0 -1 0 -1 1
        sph 0.5 -0.5 0 0.3 1
        sph 0.5 -0.5 0 0.3 1
        box -0.4 -0.5 0 0.5 1
        box -0.4 -0.5 0 0.5 1
        lgt 0 0.8 0  1 1 1  1 0.9 0.4
        """;

    @TempDir
    private Path folder;

    @BeforeEach
    void writeScene() throws Exception {
        Files.writeString(folder.resolve("scene.txt"), SCENE);
    }

    private List<String> costlyClasses(String output, String options) throws Exception {
        List<String> words = new ArrayList<>(List.of("scene.txt", output, "60", "40"));
        Stream.of(options.split(" ")).filter(word -> !word.isEmpty()).forEach(words::add);
        Program program = Program.run(Program.JAVA_HOME, List.of("-Xlog:class+load:file=classes"), folder,
            words.toArray(String[]::new));
        assertEquals(0, program.status(), program.errors());
        List<String> classes = CLASS.matcher(Files.readString(folder.resolve("classes"))).results()
            .map(match -> match.group(1)).toList();
        assertTrue(classes.contains("raytracing.shade.Shader"), classes::toString);
        return classes.stream().dropWhile(name -> !name.equals("raytracing.RayTracer")).filter(COSTLY.asPredicate()).toList();
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "--quiet", "--samples 2", "--shadows exact", "--error 8", "--error 8 --shadows sampled",
        "--opaque-shadows --seed 3 --threads 3 --shadow-rays 2", "--region 3,4,50,30", "--keep-partial"})
    void aPngNeedsNothingCostly(String options) throws Exception {
        assertEquals(List.of(), costlyClasses("out.png", options));
    }

    @Test
    void anOlderPngIsReplacedByNothingCostly() throws Exception {
        Files.writeString(folder.resolve("out.png"), "older");
        assertEquals(List.of(), costlyClasses("out.png", ""));
    }

    @Test
    void aBmpNeedsNothingCostly() throws Exception {
        assertEquals(List.of(), costlyClasses("out.bmp", ""));
    }

    /** The test sees what is costly. */
    @Test
    void aJpgNeedsPictures() throws Exception {
        assertTrue(costlyClasses("out.jpg", "").contains("javax.imageio.ImageIO"));
    }
}
