package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A disk that has room for an older picture and not for another one: 16 kB of memory, mounted for this test. */
class FullDiskTest {
    @TempDir
    private Path folder;

    @BeforeEach
    void mount() throws Exception {
        Path disk = Files.createDirectory(folder.resolve("disk"));
        Shell mount = Shell.run(folder, "mount -t tmpfs -o size=16k tmpfs " + disk);
        Skipped.unless(mount.status() == 0, "no small disk may be mounted here, so none is full");
        Files.copy(Path.of("scenes/bubbles.txt"), folder.resolve("scene.txt"));
    }

    @AfterEach
    void unmount() throws Exception {
        Shell.run(folder, "umount disk");
    }

    @ParameterizedTest
    @ValueSource(strings = {"png", "jpg", "bmp", "gif"})
    void aFullDiskLeavesTheOlderPictureAndSaysSo(String ending) throws Exception {
        String name = "out." + ending;
        Files.writeString(folder.resolve("disk").resolve(name), "older");
        Program program = Program.run(folder, "scene.txt", "disk/" + name, "300", "300", "--quiet", "--shadow-rays", "1");
        assertEquals("disk/" + name + ": could not be written: No space left on device; the file is as it was\n",
            program.errors());
        assertEquals(1, program.status());
        assertEquals("older", Files.readString(folder.resolve("disk").resolve(name)));
        assertEquals(List.of(name), Folders.names(folder.resolve("disk")));
    }

    @Test
    void aPictureThatFitsIsWritten() throws Exception {
        assertEquals(0, Program.run(folder, "scene.txt", "disk/out.png", "30", "30").status());
    }
}
