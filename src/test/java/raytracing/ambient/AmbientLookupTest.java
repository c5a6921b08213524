package raytracing.ambient;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.color.Color;
import raytracing.color.MutableColor;
import raytracing.math.Vector;
import raytracing.surface.Departure;
import raytracing.surface.Hit;
import raytracing.surface.HitRecord;

/** Records on the plane y = 0, and the light between them. */
class AmbientLookupTest {
    private static final Vector UP = new Vector(0, 1, 0);
    private static final double RADIUS = 6;
    private static final double WIDE_RADIUS = 18;

    private static Hit at(double x, double z, Vector normal) {
        return new HitRecord(0, 0, new Vector(x, 0, z), 0, normal, Departure.OUTWARD).toHit();
    }

    private static IrradianceRecord record(double x, double z, double light) {
        return new IrradianceRecord(new Vector(x, 0, z), UP, RADIUS, new Color(light, light / 2, 0));
    }

    private static AmbientLight light(List<IrradianceRecord> records, Color mean) {
        List<IrradianceRecord> wide = records.stream()
            .map(record -> new IrradianceRecord(record.point(), record.normal(), WIDE_RADIUS, record.light())).toList();
        return new AmbientLight(mean, Optional.of(AmbientLight.Records.of(records, wide, 48L * records.size())), 0);
    }

    private static AmbientLookup lookup(List<IrradianceRecord> records, double mean) {
        return new AmbientLookup(light(records, new Color(mean, mean / 2, 0)));
    }

    private static List<IrradianceRecord> scattered(int count, double size) {
        Random random = new Random(1);
        List<IrradianceRecord> records = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            records.add(record(size * random.nextDouble(), size * random.nextDouble(), random.nextDouble()));
        }
        return records;
    }

    @Test
    void nearASingleRecordThereIsItsLight() {
        MutableColor light = lookup(List.of(record(0, 0, 0.5)), 9).at(at(1, 1, UP));
        assertEquals(0.5, light.red(), 1e-15);
        assertEquals(0.25, light.green(), 1e-15);
        assertEquals(0, light.blue());
    }

    @Test
    void halfwayBetweenTwoRecordsIsTheMean() {
        assertEquals(0.5, lookup(List.of(record(0, 0, 0.25), record(2, 0, 0.75)), 9).at(at(1, 0, UP)).red(), 1e-15);
    }

    @Test
    void farFromAllRecordsIsTheMeanOfTheRoom() {
        assertEquals(9, lookup(List.of(record(0, 0, 0.5)), 9).at(at(1000, 0, UP)).red(), 1e-12);
    }

    /** 10 from the record, which counts as far as 6, and where others are missing as far as 18. */
    @Test
    void whereNoRecordIsNearTheNearestIsUsed() {
        assertEquals(0.5, lookup(List.of(record(0, 0, 0.5)), 9).at(at(10, 0, UP)).red(), 0.05);
    }

    @Test
    void lightKnowsHowManyRecordsAndPathsItHas() {
        AmbientLight light = light(scattered(3, 1), Color.BLACK);
        assertEquals(3, light.recordCount());
        assertEquals(3 * 48, light.pathCount());
        assertEquals(0, AmbientLight.even(Color.WHITE).recordCount());
        assertEquals(0, AmbientLight.even(Color.WHITE).pathCount());
    }

    /** No record of a floor counts for a wall. */
    @Test
    void aSurfaceThatIsTurnedAwayDoesNotCount() {
        assertEquals(9, lookup(List.of(record(0, 0, 0.5)), 9).at(at(0, 0, new Vector(1, 0, 0))).red(), 1e-12);
    }

    /** A step of a stair: within the radius, and turned the same way, but another surface. */
    @Test
    void aSurfaceAboveOrBelowDoesNotCount() {
        AmbientLookup lookup = lookup(List.of(record(0, 0, 0.5)), 9);
        Hit above = new HitRecord(0, 0, new Vector(0, WIDE_RADIUS / 2.9, 0), 0, UP, Departure.OUTWARD).toHit();
        assertEquals(9, lookup.at(above).red(), 1e-12);
    }

    /** Interpolated light lies between the lights it comes from: no weight is negative. */
    @Test
    void lightStaysBetweenTheLeastAndTheGreatest() {
        AmbientLookup lookup = lookup(scattered(200, 40), 0.5);
        Random random = new Random(2);
        for (int i = 0; i < 1000; i++) {
            double red = lookup.at(at(50 * random.nextDouble() - 5, 50 * random.nextDouble() - 5, UP)).red();
            assertTrue(red >= 0 && red <= 1, () -> "light " + red);
        }
    }

    /**
     * No border is seen, neither where a record begins to count nor where there are few: over a thousandth of the spacing
     * light changes by no more than a hundredth of the range. With a weight that ends abruptly it jumps by a quarter.
     */
    @ParameterizedTest
    @ValueSource(ints = {3, 20, 200, 2000})
    void lightChangesSmoothly(int count) {
        AmbientLookup lookup = lookup(scattered(count, 40), 0.5);
        double before = lookup.at(at(-8, 17 - 0.8, UP)).red();
        for (double x = -8; x < 48; x += 0.001) {
            double red = lookup.at(at(x, 17 + 0.1 * x, UP)).red();
            assertEquals(before, red, 0.01);
            before = red;
        }
    }

    @Test
    void lightThatDoesNotVaryIsTheSameEverywhere() {
        AmbientLookup lookup = new AmbientLookup(AmbientLight.even(new Color(1, 2, 3)));
        assertEquals(new Color(1, 2, 3), lookup.at(at(5, 6, UP)).toColor());
    }
}
