package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Names with other letters than English ones, also where the locale has none, as under cron and in containers. */
class LocaleTest {
    private static final String ADVICE = " in this locale; begin the command with LC_ALL=C.UTF-8\n";

    @TempDir
    private Path folder;

    @BeforeEach
    void writeScene() throws Exception {
        Files.writeString(folder.resolve("scene.txt"), "cam 0 0 -5 0 0 0 0 1 0 1 1\nset 0.25 0.5 1 1 1\n");
    }

    /** A Hebrew word and a French one, in bytes of UTF-8, because the tests themselves may run in any locale. */
    private Shell shell(String... commands) throws Exception {
        String[] all = new String[commands.length + 1];
        all[0] = "hebrew=$(printf '\\327\\251\\327\\234'); french=$(printf 'caf\\303\\251'); latin=$(printf 'caf\\351'); "
            + "draw() { LC_ALL=$1 \"$JAVA\" -jar \"$JAR\" \"$2\" \"$3\" 8 4 --quiet; }";
        System.arraycopy(commands, 0, all, 1, commands.length);
        return Shell.run(folder, all);
    }

    @ParameterizedTest(name = "{0} {1}")
    @CsvSource({
        "$hebrew.txt,       out.png,         ????.txt: Java cannot read all letters of this name",
        "$hebrew/scene.txt, out.png,         ????/scene.txt: Java cannot read all letters of this name",
        "scene.txt,         $french.png,     caf??.png: Java cannot read all letters of this name",
        "scene.txt,         $french/out.png, caf??/out.png: Java cannot read all letters of this name",
    })
    void aNameThatTheLocaleHasNoLettersForIsSaid(String scene, String output, String sentence) throws Exception {
        Shell shell = shell("mkdir $hebrew $french && cp scene.txt $hebrew && cp scene.txt $hebrew.txt",
            "draw C " + scene + " " + output, "status=$?", "rm -r $hebrew $french $hebrew.txt", "exit $status");
        assertEquals(new Shell(2, sentence + ADVICE), shell);
        assertEquals(List.of("scene.txt"), Folders.names(folder));
    }

    /** Java finds nothing by relative names there, though the files have English ones. */
    @Test
    void aFolderThatTheLocaleHasNoLettersForIsSaid() throws Exception {
        Shell shell = shell("mkdir $french && cp scene.txt $french && cd $french", "draw C scene.txt out.png",
            "status=$?", "rm scene.txt && rmdir $PWD", "exit $status");
        assertEquals(new Shell(2, "scene.txt: Java cannot read all letters of the folder that it runs in" + ADVICE), shell);
    }

    @Test
    void theLocaleOfTheAdviceHelps() throws Exception {
        Skipped.unless(Shell.run(folder, "locale -a | grep -qi 'C.utf-\\?8'").status() == 0,
            "there is no locale C.UTF-8 here");
        Shell shell = shell("mkdir $french && cp scene.txt $french/$hebrew.txt && cd $french",
            "draw C.UTF-8 $hebrew.txt $french.png", "status=$?", "cd ..", "rm $french/$french.png || status=9",
            "rm -r $french", "exit $status");
        assertEquals(new Shell(0, ""), shell);
    }

    /** A file from an old system, with a name that is not valid in any encoding of today. */
    @Test
    void aNameThatIsNotInUtf8IsToBeRenamed() throws Exception {
        Skipped.unless(Shell.run(folder, "locale -a | grep -qi 'C.utf-\\?8'").status() == 0,
            "there is no locale C.UTF-8 here");
        Shell shell = shell("cp scene.txt $latin.txt", "draw C.UTF-8 $latin.txt out.png", "status=$?", "rm $latin.txt",
            "exit $status");
        assertEquals(new Shell(2, "caf\ufffd.txt: Java cannot read all letters of this name, which is not in UTF-8 as "
            + "this locale is; rename it\n"), shell);
    }
}
