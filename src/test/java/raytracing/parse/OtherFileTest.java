package raytracing.parse;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayOutputStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.film.Film;
import raytracing.film.ImageFile;
import raytracing.film.ImageFormat;
import raytracing.parallel.ForkJoin;

/** Files that are no scene files are called what they are, in one sentence. */
class OtherFileTest {
    private static final String SCENE = "cam 0 0 -5  0 0 0  0 1 0  1 2\r\nset 0 0 0  4 10\r\n";

    private static List<String> messages(byte[] bytes) {
        return assertThrows(RayTracerException.class, () -> SceneParser.parse("a.txt", bytes, ForkJoin.sequential())).messages();
    }

    private static void assertCalled(String kind, byte[] bytes) {
        assertEquals(List.of("a.txt: is " + kind + ", expected a scene file in UTF-8"), messages(bytes));
    }

    @ParameterizedTest
    @ValueSource(strings = {SCENE, "# a title\r\n\r\n" + SCENE, "\r\n  \t" + SCENE, "#\n" + SCENE})
    void textWithMoreBytesForACharacterIsNamed(String text) {
        assertCalled("UTF-16 text without a byte-order mark", text.getBytes(StandardCharsets.UTF_16LE));
        assertCalled("UTF-16 text without a byte-order mark", text.getBytes(StandardCharsets.UTF_16BE));
        for (String order : List.of("UTF-32LE", "UTF-32BE")) {
            assertCalled("UTF-32 text", text.getBytes(Charset.forName(order)));
            assertCalled("UTF-32 text", ("\ufeff" + text).getBytes(Charset.forName(order)));
        }
    }

    @ParameterizedTest
    @CsvSource({"PNG, a PNG picture", "JPEG, a JPEG picture", "GIF, a GIF picture", "BMP, no text"})
    void aPictureIsNamed(ImageFormat format, String kind, @TempDir Path folder)
            throws Exception {
        Film film = new Film(4, 3);
        film.set(1, 1, 1, 0.5, 0);
        Path file = folder.resolve("picture");
        new ImageFile(file, format).write(film);
        assertCalled(kind, Files.readAllBytes(file));
    }

    @Test
    void aJarIsNamed() throws Exception {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (JarOutputStream jar = new JarOutputStream(bytes)) {
            jar.putNextEntry(new JarEntry("a"));
        }
        assertCalled("a zip or jar file", bytes.toByteArray());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "{\\rtf1\\ansi cam 0 0 0         | an RTF file of a word processor",
        "<!DOCTYPE html><title>a</title> | a web page",
        "<html><body>                    | a web page",
        "%PDF-1.7                        | a PDF file",
    })
    void textThatIsOnlyTheWayToATextIsNamed(String text, String kind) {
        assertCalled(kind, text.getBytes(StandardCharsets.US_ASCII));
    }

    @Test
    void zerosAreNoText() {
        assertCalled("no text", new byte[100_000]);
    }

    @Test
    void aSceneWithErrorsIsAScene() {
        assertEquals(List.of("a.txt:3: 1<U+0000>: unknown code (U+0000 NULL, leave it out), "
            + "expected cam, set, mtl, sph, pln, box, trg or lgt"), messages((SCENE + "1\0\r\n").getBytes(StandardCharsets.UTF_8)));
        assertEquals(List.of("a.txt: set: missing, expected exactly one"),
            messages(("# \0 \u0089PNG\n" + SCENE.lines().findFirst().orElseThrow()).getBytes(StandardCharsets.UTF_8)));
    }

    /** Old systems end a text with Ctrl-Z, and fill the rest of a block with it. */
    @ParameterizedTest
    @ValueSource(strings = {"\u001a", "\u001a\u001a\u001a", "\u001a\r\n", "\r\n\u001a \n\u001a\n", "  \u001a"})
    void aCtrlZAtTheVeryEndIsNoPartOfTheText(String end) throws RayTracerException {
        String text = SCENE.strip() + end;
        assertEquals(SceneParser.parse("a.txt", SCENE.getBytes(StandardCharsets.UTF_8), ForkJoin.sequential()),
            SceneParser.parse("a.txt", text.getBytes(StandardCharsets.UTF_8), ForkJoin.sequential()));
        assertEquals(SceneParser.parse("a.txt", SCENE.getBytes(StandardCharsets.UTF_8), ForkJoin.sequential()),
            SceneParser.parse("a.txt", ("\ufeff" + text).getBytes(StandardCharsets.UTF_16LE), ForkJoin.sequential()));
    }

    @Test
    void elsewhereACtrlZIsNamed() {
        assertEquals(List.of("a.txt:3: <U+001A>: unknown code (U+001A SUBSTITUTE, leave it out), "
            + "expected cam, set, mtl, sph, pln, box, trg or lgt"),
            messages((SCENE + "\u001a\r\n# the end").getBytes(StandardCharsets.UTF_8)));
    }
}
