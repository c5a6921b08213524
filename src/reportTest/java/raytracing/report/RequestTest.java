package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import raytracing.parse.RayTracerException;

class RequestTest {
    @Test
    void withoutAWordAllScenesAreDrawn() throws Exception {
        Request request = Request.of(List.of());
        assertTrue(request.scenes().contains(Path.of("scenes", "room.txt")));
        assertEquals("gradle report", request.command());
        assertEquals(Budget.OF_MANY, request.budget());
    }

    @Test
    void aSingleSceneHasMoreTime() throws Exception {
        Request request = Request.of(List.of("scene=scenes/room.txt", "size=64"));
        assertEquals(List.of(Path.of("scenes/room.txt")), request.scenes());
        assertEquals(Budget.OF_ONE.withSize(64), request.budget());
        assertEquals("gradle report -Pscene=scenes/room.txt -Psize=64", request.command());
    }

    @Test
    void thePageNamesNoFoldersOfItsWriter() throws Exception {
        String file = Path.of("private", "room.txt").toAbsolutePath().toString();
        assertEquals("gradle report -Pscene=room.txt", Request.of(List.of("scene=" + file)).command());
    }

    @Test
    void aBadSizeGetsASentence() {
        RayTracerException wrong = assertThrows(RayTracerException.class, () -> Request.of(List.of("size=10")));
        assertEquals(List.of("size: must be a whole number from 11 to 2000, got 10"), wrong.messages());
        assertThrows(RayTracerException.class, () -> Request.of(List.of("size=big")));
    }
}
