package raytracing.shade;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.color.Color;
import raytracing.geometry.Departure;
import raytracing.geometry.Hit;
import raytracing.geometry.HitPoint;
import raytracing.math.Vector;

/** Places on the plane y = 0 with light that was gathered by nobody, and what lies between them. */
class AmbientLookupTest {
    private static final Vector UP = new Vector(0, 1, 0);

    private static HitPoint at(double x, double z, Vector normal) {
        HitPoint point = new HitPoint();
        point.take(new Hit(0, 0, 1, new Vector(x, 0, z), 0, normal, Departure.OUTWARD));
        return point;
    }

    private static Place place(double x, double z, double light) {
        Place place = new Place(at(x, z, UP), 1, 1);
        place.light.add(light, light / 2, 0);
        return place;
    }

    private static AmbientLookup lookup(List<Place> places, double mean) {
        return new AmbientLookup(AmbientLight.between(places, Color.BLACK, new Color(mean, mean / 2, 0)));
    }

    private static List<Place> scattered(int count, double size) {
        Random random = new Random(1);
        List<Place> places = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            places.add(place(size * random.nextDouble(), size * random.nextDouble(), random.nextDouble()));
        }
        return places;
    }

    @Test
    void nearASinglePlaceThereIsItsLight() {
        LightSum light = lookup(List.of(place(0, 0, 0.5)), 9).at(at(1, 1, UP));
        assertEquals(0.5, light.red(), 1e-15);
        assertEquals(0.25, light.green(), 1e-15);
        assertEquals(0, light.blue());
    }

    @Test
    void halfwayBetweenTwoPlacesIsTheMean() {
        assertEquals(0.5, lookup(List.of(place(0, 0, 0.25), place(2, 0, 0.75)), 9).at(at(1, 0, UP)).red(), 1e-15);
    }

    @Test
    void farFromAllPlacesIsTheMeanOfTheRoom() {
        assertEquals(9, lookup(List.of(place(0, 0, 0.5)), 9).at(at(1000, 0, UP)).red(), 1e-12);
    }

    /** 10 from the place, whose light counts as far as 6, and for want of others as far as 18. */
    @Test
    void whereNoPlaceIsNearTheNearestStandsIn() {
        assertEquals(0.5, lookup(List.of(place(0, 0, 0.5)), 9).at(at(10, 0, UP)).red(), 0.05);
    }

    @Test
    void lightKnowsAtHowManyPlacesItWasGathered() {
        assertEquals(3, AmbientLight.between(scattered(3, 1), Color.BLACK, Color.BLACK).placeCount());
        assertEquals(0, AmbientLight.even(Color.WHITE).placeCount());
    }

    /** A wall does not ask the floor. */
    @Test
    void aSurfaceThatIsTurnedAwayDoesNotCount() {
        assertEquals(9, lookup(List.of(place(0, 0, 0.5)), 9).at(at(0, 0, new Vector(1, 0, 0))).red(), 1e-12);
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
     * No border is seen, neither where a place begins to count nor where there are few: over a thousandth of the spacing
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
        assertEquals(new Color(1, 2, 3), lookup.at(at(5, 6, UP)).total());
    }

    @Test
    void placesReachFurtherWhereMoreIsFree() {
        Place narrow = place(0, 0, 1);
        narrow.addNearness(1 / 3.0);
        Place medium = place(0, 0, 1);
        medium.addNearness(0.1);
        Place wide = place(0, 0, 1);
        assertEquals(2, narrow.radius());
        assertEquals(3.5, medium.radius(), 1e-15);
        assertEquals(6, wide.radius());
    }

    @Test
    void placesThatLieFurtherApartReachFurther() {
        Place far = new Place(at(0, 0, UP), 3, 1);
        assertEquals(6 * 3, far.radius());
        far.addNearness(1);
        assertEquals(2 * 3, far.radius());
    }

    /** Seen at a cosine of a quarter, places lie four times as far apart in one direction: the root of it is 2. */
    @Test
    void placesReachFurtherOnSurfacesThatTheEyeLooksAlong() {
        Place slanted = new Place(at(0, 0, UP), 1, 0.25);
        slanted.addNearness(1);
        assertEquals(4, slanted.radius());
        assertEquals(3 * 4 * 4, slanted.wideRadius());
    }
}
