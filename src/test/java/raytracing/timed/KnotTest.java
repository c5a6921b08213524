package raytracing.timed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.math.Vector;
import raytracing.surface.Triangle;

class KnotTest {
    private static final int ALONG = 300;
    private static final int AROUND = 40;

    private final List<Triangle> triangles = Knot.scene(ALONG, AROUND, 1).surfaces().stream()
        .filter(Triangle.class::isInstance).map(Triangle.class::cast).toList();

    private record Edge(Vector from, Vector to) {
    }

    /** Each ring has two triangles for each of its points; and there is the floor. */
    @ParameterizedTest
    @CsvSource({"3, 3, 18", "625, 80, 100000"})
    void anyNumberOfTrianglesIsPossible(int along, int around, int count) {
        assertEquals(count + 1, Knot.scene(along, around, 1).surfaces().size());
    }

    /** So the mesh is closed, and all normals point to the same side of it. */
    @Test
    void everyEdgeIsThatOfTwoTrianglesInOppositeDirections() {
        Map<Edge, Integer> edges = new HashMap<>();
        for (Triangle triangle : triangles) {
            edges.merge(new Edge(triangle.a(), triangle.b()), 1, Integer::sum);
            edges.merge(new Edge(triangle.b(), triangle.c()), 1, Integer::sum);
            edges.merge(new Edge(triangle.c(), triangle.a()), 1, Integer::sum);
        }
        edges.forEach((edge, count) -> {
            assertEquals(1, count, edge::toString);
            assertTrue(edges.containsKey(new Edge(edge.to, edge.from)), edge::toString);
        });
    }

    /** Corners less edges and triangles: 0 for a surface with one hole, such as a knotted tube. */
    @Test
    void itHasOneHole() {
        Set<Vector> corners = new HashSet<>();
        triangles.forEach(triangle -> corners.addAll(List.of(triangle.a(), triangle.b(), triangle.c())));
        assertEquals(ALONG * AROUND, corners.size());
        assertEquals(0, corners.size() - 3 * triangles.size() / 2 + triangles.size());
    }

    /**
     * By Pappus, the volume of a tube is its length times the area across it; that of a polygon of n corners is n / 2 sin(2 pi
     * / n) times the squared radius. The pieces between rings are straight and a little twisted, which is less than 0.5 %.
     */
    @Test
    void normalsPointOutOfATubeOfTheRightVolume() {
        double volume = triangles.stream().mapToDouble(each -> each.a().dot(each.b().cross(each.c())) / 6).sum();
        double length = IntStream.range(0, ALONG).mapToDouble(i -> centre(i + 1).minus(centre(i)).length()).sum();
        double area = AROUND * Math.sin(2 * Math.PI / AROUND) / 2 * Knot.TUBE * Knot.TUBE;
        assertEquals(length * area, volume, 5e-3 * volume);
    }

    private static Vector centre(int i) {
        return Knot.centre(2 * Math.PI * i / ALONG);
    }

    /** Where the knot comes back to the same place, it passes on the other side of its torus. */
    @Test
    void theTubeDoesNotMeetItself() {
        for (int i = 0; i < ALONG; i++) {
            for (int j = i + ALONG / 6; j < i + ALONG - ALONG / 6; j++) {
                double distance = centre(i).minus(centre(j)).length();
                assertTrue(distance > 2 * Knot.TUBE, "rings " + i + ", " + j % ALONG + ": " + distance);
            }
        }
    }

    @Test
    void nothingReachesBelowTheFloor() {
        assertTrue(triangles.stream().flatMapToDouble(triangle -> DoubleStream.of(triangle.ay(), triangle.by(), triangle.cy()))
            .allMatch(height -> height > -0.7));
    }

    @Test
    void shadowRaysAreAsManyAsAskedFor() {
        assertEquals(3, Knot.scene(3, 3, 3).settings().shadowRayRoot());
    }
}
