package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import raytracing.math.Vector;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

class KnotSceneTest {
    private static final int TRIANGLES = 2 * KnotScene.ROWS * KnotScene.CORNERS;
    private static final long MEGABYTE = 1_000_000;

    /** An edge, in the direction in which a triangle's corners follow each other. */
    private record Edge(Vector from, Vector to) {
    }

    private static List<Triangle> triangles() throws Exception {
        return Steps.parseScene(KnotScene.FILE).surfaces().stream().filter(Triangle.class::isInstance)
            .map((Surface surface) -> (Triangle) surface).toList();
    }

    @Test
    void theCommittedFileIsWhatTheGeneratorWrites() throws Exception {
        assertEquals(KnotScene.text(), Files.readString(KnotScene.FILE), "gradle mesh writes it anew");
        assertTrue(Files.size(KnotScene.FILE) <= MEGABYTE);
    }

    /** Also after rounding to the digits of the file: each edge is that of two triangles, which go along it in opposite ways. */
    @Test
    void theMeshIsClosed() throws Exception {
        Map<Edge, Integer> edges = new HashMap<>();
        for (Triangle t : triangles()) {
            for (Edge edge : List.of(new Edge(t.a(), t.b()), new Edge(t.b(), t.c()), new Edge(t.c(), t.a()))) {
                edges.merge(edge, 1, Integer::sum);
            }
        }
        assertEquals(3 * TRIANGLES, edges.size());
        edges.keySet().forEach(edge -> assertTrue(edges.containsKey(new Edge(edge.to(), edge.from())), edge::toString));
    }

    /** No two corners of the tube round to the same digits. */
    @Test
    void theMeshHasAsManyCornersAsATorus() throws Exception {
        Set<Vector> corners = new HashSet<>();
        triangles().forEach(t -> corners.addAll(List.of(t.a(), t.b(), t.c())));
        assertEquals(TRIANGLES, triangles().size());
        assertEquals(TRIANGLES / 2, corners.size());
    }
}
