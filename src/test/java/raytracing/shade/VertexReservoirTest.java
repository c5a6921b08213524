package raytracing.shade;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import raytracing.color.Color;
import raytracing.color.MutableColor;
import raytracing.math.CounterRandom;
import raytracing.math.Vector;
import raytracing.scene.Material;
import raytracing.surface.Departure;
import raytracing.surface.Hit;
import raytracing.surface.HitRecord;

class VertexReservoirTest {
    private static final int DRAWS = 100_000;

    private static Material material(Color diffuse, double transparency, Color ambient) {
        return new Material(diffuse, Color.BLACK, Color.BLACK, 1, transparency, ambient);
    }

    private static Material diffuse(double red, double green, double blue) {
        return material(new Color(red, green, blue), 0, Color.BLACK);
    }

    private static Hit at(double z) {
        return new HitRecord((int) z, 0, new Vector(0, 0, z), 0, new Vector(0, 0, -1), Departure.OUTWARD).toHit();
    }

    private static MutableColor weight(double all) {
        MutableColor weight = new MutableColor();
        weight.set(all, all, all);
        return weight;
    }

    private static VertexReservoir vertex() {
        return new VertexReservoir(VertexReservoir.Scattering.DIFFUSE);
    }

    /** Chances 0.1, 0.2 and 0.3; a binomial count is off by six standard deviations once in 500 million. */
    @Test
    void aPointIsDrawnInProportionToWhatComesBackFromIt() {
        int[] counts = new int[3];
        VertexReservoir vertex = vertex();
        for (int draw = 0; draw < DRAWS; draw++) {
            vertex.clear();
            for (int i = 0; i < 3; i++) {
                vertex.offer(at(i), diffuse(0.5, 0.1, 0), weight(0.2 * (i + 1)), CounterRandom.bits(draw, i));
            }
            counts[vertex.hit().surface()]++;
        }
        for (int i = 0; i < 3; i++) {
            double chance = (i + 1) / 6.0;
            assertEquals(chance * DRAWS, counts[i], 6 * Math.sqrt(chance * (1 - chance) * DRAWS));
        }
    }

    /** Red 0.3 and 0.1, green 0 and 0.4: weighted with lights of 1 and 2, 0.3 + 0.2 and 0.8. */
    @Test
    void theMeanOverAllDrawsIsTheSumOverAllPoints() {
        double red = 0;
        double green = 0;
        VertexReservoir vertex = vertex();
        for (int draw = 0; draw < DRAWS; draw++) {
            vertex.clear();
            vertex.offer(at(0), diffuse(0.3, 0, 0), weight(1), CounterRandom.bits(draw, 0));
            vertex.offer(at(1), diffuse(0.1, 0.4, 0), weight(1), CounterRandom.bits(draw, 1));
            MutableColor path = weight(1);
            vertex.filter(path);
            red += path.red() * (vertex.hit().surface() + 1) / DRAWS;
            green += path.green() * (vertex.hit().surface() + 1) / DRAWS;
        }
        double bound = 6 * 0.7 / Math.sqrt(DRAWS);      // no draw counts more than the sum of the chances, 0.7, times light
        assertEquals(0.5, red, 2 * bound);
        assertEquals(0.8, green, 2 * bound);
    }

    @Test
    void noMoreThanNineTenthsComeBack() {
        VertexReservoir vertex = vertex();
        vertex.clear();
        vertex.offer(at(0), diffuse(3, 0.9, 0.5), weight(1), 1);
        MutableColor path = weight(1);
        vertex.filter(path);
        assertEquals(0.9, path.red(), 1e-15);
        assertEquals(0.9, path.green(), 1e-15);
        assertEquals(0.5, path.blue(), 1e-15);
    }

    @Test
    void whatIsTransparentSendsBackLess() {
        VertexReservoir vertex = vertex();
        vertex.clear();
        vertex.offer(at(0), material(Color.WHITE, 0.75, Color.BLACK), weight(0.5), 1);
        MutableColor path = weight(1);
        vertex.filter(path);
        assertEquals(0.125, path.red(), 1e-15);
    }

    @ParameterizedTest
    @EnumSource(value = VertexReservoir.Scattering.class, names = {"DIFFUSE", "AMBIENT"})
    void onlyTheColourThatScattersCounts(VertexReservoir.Scattering scattering) {
        boolean isDiffuse = scattering == VertexReservoir.Scattering.DIFFUSE;
        VertexReservoir vertex = new VertexReservoir(scattering);
        vertex.clear();
        vertex.offer(at(0), material(isDiffuse ? Color.BLACK : Color.WHITE, 0, isDiffuse ? Color.WHITE : Color.BLACK),
            weight(1), 1);
        assertFalse(vertex.isFound());
    }

    /** Something black is in the way all the same. */
    @Test
    void theFirstPointMetIsTheNearestEvenIfNoPathGoesOnFromIt() {
        VertexReservoir vertex = vertex();
        vertex.clear();
        vertex.offer(at(2), diffuse(0, 0, 0), weight(1), 1);
        vertex.offer(at(8), diffuse(1, 1, 1), weight(1), 1);
        assertTrue(vertex.isFound());
        assertEquals(0.5, vertex.nearness(at(0)));
    }

    @Test
    void aRayThatMeetsNothingHasNoNearest() {
        VertexReservoir vertex = vertex();
        vertex.clear();
        assertFalse(vertex.isFound());
        assertEquals(0, vertex.nearness(at(0)));
    }
}
