package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import raytracing.timed.Knot;
import raytracing.timed.SceneLines;

/** A mesh fits into the heap that its number of triangles suggests, the bytes of its file included. */
class MeshMemoryTest {
    @TempDir
    private Path folder;

    /**
     * 12 MB are those of the file, and a triangle has 200 bytes at most once the hierarchy is built: that leaves 8 MB for the
     * picture and all else. A million triangles have 640 MB, so they have more.
     */
    @Test
    void aHundredThousandTrianglesNeedAtMost40MegabytesOfHeap() throws Exception {
        Files.writeString(folder.resolve("scene.txt"), SceneLines.of(Knot.scene(625, 80, 1)));
        Program program = Program.run(Program.JAVA_HOME, List.of("-Xmx40m"), folder, "scene.txt", "out.png", "100", "100");
        assertEquals(0, program.status(), program.errors());
    }
}
