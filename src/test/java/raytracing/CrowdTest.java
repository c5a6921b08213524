package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CrowdTest {
    /** {@code gradle trust} has 64 at once. */
    @Test
    void manyProgramsDoNotDisturbEachOther(@TempDir Path folder) throws Exception {
        Crowd.draw(folder, 8);
        assertEquals(List.of(), Folders.names(folder).stream().filter(name -> name.startsWith(".")).toList());
    }
}
