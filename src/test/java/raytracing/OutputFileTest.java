package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The file of a picture: its names, the links that lead to it, and its permissions. */
class OutputFileTest {
    private static final String SCENE = "cam 0 0 -5 0 0 0 0 1 0 1 1\nset 0.25 0.5 1 1 1\n";

    @TempDir
    private Path folder;

    @BeforeEach
    void writeScene() throws Exception {
        Files.writeString(folder.resolve("scene.txt"), SCENE);
    }

    /** In bash, which can set masks, links and permissions. */
    private Shell shell(String... commands) throws Exception {
        return Shell.run(folder, commands);
    }

    private static String draw(String scene, String output) {
        return "\"$JAVA\" -jar \"$JAR\" " + scene + " " + output + " 8 4 --quiet";
    }

    private void assertPicture(String name) throws Exception {
        assertEquals(8, ImageIO.read(folder.resolve(name).toFile()).getWidth());
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "the same name,          true,                    scene.png",
        "the same name by a way, mkdir sub,               sub/../scene.png",
        "a symbolic link,        ln -s scene.png out.png, out.png",
        "a hard link,            ln scene.png out.png,    out.png",
    })
    void aPictureNeverReplacesItsScene(String kind, String command, String output) throws Exception {
        Files.writeString(folder.resolve("scene.png"), SCENE);
        Shell shell = shell(command, draw("scene.png", output));
        String link = kind.equals("a symbolic link") ? "is a link to scene.png: " : "";
        assertEquals(output + ": " + link
            + "is the scene itself, which the picture would replace; give the picture another name\n", shell.text());
        assertEquals(2, shell.status());
        assertEquals(SCENE, Files.readString(folder.resolve("scene.png")));
    }

    @ParameterizedTest
    @ValueSource(strings = {"600", "664", "755"})
    void aReplacedPictureKeepsItsMode(String mode) throws Exception {
        Shell shell = shell("umask 027", "touch out.png", "chmod " + mode + " out.png", draw("scene.txt", "out.png"),
            "stat -c %a out.png");
        assertEquals(mode + "\n", shell.text());
        assertPicture("out.png");
    }

    @Test
    void aNewPictureHasTheModeThatTheMaskLeaves() throws Exception {
        assertEquals("640\n", shell("umask 027", draw("scene.txt", "out.png"), "stat -c %a out.png").text());
    }

    @Test
    void aReplacedPictureKeepsOwnerAndGroupIfRootDrawsIt() throws Exception {
        Skipped.unless(shell("touch out.png && chown 12345:54321 out.png").status() == 0, "only root may give files away");
        assertEquals("12345 54321\n", shell(draw("scene.txt", "out.png"), "stat -c '%u %g' out.png").text());
    }

    /** The picture belongs to a group of which the user is no member: no other group may get its permissions. */
    @Test
    void rightsOfAGroupThatCannotBeKeptGoToNoOtherOne() throws Exception {
        assumeOtherUsers();
        Shell shell = shell("touch out.png && chown 12345:54321 out.png && chmod 662 out.png && chmod 777 .",
            "setpriv --reuid=12345 --regid=12345 --clear-groups " + draw("scene.txt", "out.png"),
            "stat -c '%a %u %g' out.png");
        assertEquals("622 12345 12345\n", shell.text());
    }

    /** Folders of tests are for their owner alone, who is root here: others must get through to this one. */
    private void assumeOtherUsers() throws Exception {
        boolean possible = Shell.has("setpriv") && shell("[ $(id -u) = 0 ] && chmod 755 . && "
            + "setpriv --reuid=12345 --regid=12345 --clear-groups \"$JAVA\" -jar \"$JAR\" --version").status() == 0;
        Skipped.unless(possible, "only root can try what other users may do, with setpriv and a jar they can read");
    }

    /** As in /tmp; without the sticky bit, every user who may write in the folder may replace the file. */
    @Test
    void anotherUsersPictureInAStickyFolderIsRefusedBeforeAnythingIsDrawn() throws Exception {
        assumeOtherUsers();
        String another = "setpriv --reuid=12345 --regid=12345 --clear-groups " + draw("no.txt", "sticky/out.png");
        Shell shell = shell("mkdir sticky && chmod 1777 sticky", "touch sticky/out.png && chmod 666 sticky/out.png", another);
        assertEquals("sticky/out.png: belongs to another user, who alone may replace it in this folder; "
            + "give the picture another name\n", shell.text());
        assertEquals(2, shell.status());
        assertEquals("no.txt: no such file, expected a scene file\n", shell("chmod 777 sticky", another).text());
        assertEquals(List.of("out.png"), Folders.names(folder.resolve("sticky")));
    }

    @Test
    void aFolderThatMayNotBeWrittenIsRefusedBeforeAnythingIsDrawn() throws Exception {
        assumeOtherUsers();
        Shell shell = shell("mkdir hers", "setpriv --reuid=12345 --regid=12345 --clear-groups "
            + draw("no.txt", "hers/out.png"));
        assertEquals("hers/out.png: may not write in this folder\n", shell.text());
        assertEquals(2, shell.status());
    }

    @Test
    void aFileSystemThatIsOnlyForReadingIsSaidBeforeAnythingIsDrawn() throws Exception {
        Shell mount = shell("mkdir disk && mount -t tmpfs -o ro tmpfs disk");
        Skipped.unless(mount.status() == 0, "no disk may be mounted here, so none is only for reading");
        Shell shell = shell(draw("no.txt", "disk/out.png"), "status=$?", "umount disk", "exit $status");
        assertEquals("disk/out.png: could not be written: Read-only file system; the file is as it was\n", shell.text());
        assertEquals(1, shell.status());
    }

    /** The unfinished file has a shorter name, so that its creation says nothing about this one. */
    @Test
    void aNameThatIsTooLongIsRefusedBeforeAnythingIsDrawn() throws Exception {
        String name = "a".repeat(252) + ".png";
        Shell shell = shell(draw("no.txt", name));
        assertEquals(name + ": File name too long\n", shell.text());
        assertEquals(2, shell.status());
        assertEquals(0, shell(draw("scene.txt", name.substring(1))).status());
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "ln -s target.png out.png,                                   target.png",
        "ln -s sub/target.png out.png,                               sub/target.png",
        "ln -s sub/link out.png && ln -s ../target.png sub/link,     target.png",
        "ln -s sub folder && ln -s ../target.png sub/out && ln -s folder/out out.png, target.png",
        "ln -s \"$PWD/target.png\" out.png,                          target.png",
    })
    void linksAreFollowedWhetherTheFileIsThereOrNot(String links, String target) throws Exception {
        Shell first = shell("mkdir sub", links, draw("scene.txt", "out.png"));
        assertEquals(new Shell(0, ""), first);
        assertTrue(Files.isSymbolicLink(folder.resolve("out.png")));
        assertPicture(target);
        Files.writeString(folder.resolve(target), "older");
        assertEquals(new Shell(0, ""), shell(draw("scene.txt", "out.png")));
        assertTrue(Files.isSymbolicLink(folder.resolve("out.png")));
        assertPicture(target);
    }

    @Test
    void aLinkIntoAMissingFolderIsRefusedWithThePlaceItLeadsTo() throws Exception {
        Shell shell = shell("ln -s none/target.png out.png", draw("no.txt", "out.png"));
        assertEquals("out.png: is a link to none/target.png: no such folder\n", shell.text());
        assertEquals(2, shell.status());
    }

    @Test
    void aLinkInACircleIsRefused() throws Exception {
        Shell shell = shell("ln -s b.png a.png && ln -s a.png b.png", draw("no.txt", "a.png"));
        assertTrue(shell.text().startsWith("a.png: Too many levels of symbolic links"), shell.text());
        assertEquals(2, shell.status());
    }

    /** The other names keep the older picture: FORMAT says so. */
    @Test
    void ofAFileWithTwoNamesOnlyTheOneThatIsDrawnToChanges() throws Exception {
        assertEquals(new Shell(0, "older"), shell("printf older > other.png", "ln other.png out.png",
            draw("scene.txt", "out.png"), "cat other.png"));
        assertPicture("out.png");
    }
}
