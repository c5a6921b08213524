package raytracing.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.math.ExactVector;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/** Random queries are as hard as their family's name says. */
class FamiliesTest {
    private static final int SIZE = 1_000;

    @ParameterizedTest(name = "{0}")
    @MethodSource(AllFamilies.NAMED)
    void theSameSeedDrawsTheSameQueries(Family family) {
        assertEquals(family.queries(1, SIZE).stream().toList(),
            family.queries(1, SIZE).stream().toList());
    }

    /** From inside a body every ray hits. A family without misses would not notice a formula that never misses. */
    @ParameterizedTest(name = "{0}")
    @MethodSource(AllFamilies.NAMED)
    void everyFamilyHasHitsAndMisses(Family family) {
        double hits = family.sample(1, SIZE).shareOfHits();
        boolean fromInside = family.title().equals("inside");
        assertTrue(fromInside ? hits == 1 : hits > 0.2 && hits < 0.95, "share of hits " + hits);
    }

    @ParameterizedTest
    @EnumSource
    void ordinaryRaysMeetSixteenSurfacesAndHitAboutHalf(Shape shape) {
        Family ordinary = shape.families().get(0);
        assertEquals(16, ordinary.recipe().surfacesPerRay());
        assertEquals(0.5, ordinary.sample(1, 4 * SIZE).shareOfHits(), 0.05);
    }

    @Test
    void queriesOfARayShareIt() {
        Queries queries = SphereFamily.ORDINARY.queries(1, 32);
        assertEquals(queries.get(16).direction(), queries.get(31).direction());
        assertTrue(!queries.get(15).direction().equals(queries.get(16).direction()));
        assertTrue(!queries.get(16).vector().equals(queries.get(17).vector()));
    }

    /** What a benchmark times is what the tests judge. */
    @ParameterizedTest
    @EnumSource
    void walkingTheArraysAnswersTheSameQueries(Shape shape) {
        Queries queries = shape.families().get(0).queries(1, SIZE);
        Formula ours = shape.ours().formula();
        double sum = queries.stream().mapToDouble(ours::firstCrossing).filter(t -> t < Formula.MISS).sum();
        assertEquals(sum, queries.sumOfCrossings(ours), 1e-12 * sum);
    }

    @Test
    void originsOnASphereAreOnItButForRounding() {
        Failures.assertNone(SphereFamily.ON_THE_SURFACE.queries(1, SIZE).stream()
            .filter(query -> ExactSphere.distance(ExactVector.of(query.origin()), ExactVector.of(query.vector()),
                new BigDecimal(query.scalar())).doubleValue() > 16 * Math.ulp(16))
            .map(Query::toString));
    }

    @Test
    void originsOnAPlaneAreOnItButForRounding() {
        Failures.assertNone(PlaneFamily.ON_THE_PLANE.queries(1, SIZE).stream()
            .filter(query -> ExactPlane.distance(ExactVector.of(query.origin()), ExactVector.of(query.vector()),
                new BigDecimal(query.scalar())).doubleValue() > 4 * Math.ulp(16))
            .map(Query::toString));
    }

    @Test
    void originsOnAFaceAreBesideABoxByLessThanAnUlp() {
        Failures.assertNone(BoxFamily.ON_A_FACE.queries(1, SIZE).stream()
            .filter(query -> besideAFace(query) > Math.ulp(16))
            .map(Query::toString));
    }

    private static double besideAFace(Query query) {
        ExactVector fromCentre = ExactVector.of(query.origin()).minus(ExactVector.of(query.vector()));
        return Stream.of(new Vector(1, 0, 0), new Vector(0, 1, 0), new Vector(0, 0, 1))
            .flatMap(axis -> Stream.of(axis, Vectors.negated(axis)))
            .mapToDouble(face -> ExactBox.distanceToFace(fromCentre, face, ExactBox.half(query.scalar())).doubleValue())
            .min().orElseThrow();
    }

    /** Half of the rays through an edge meet it exactly, and a ray that meets it in one point touches it. */
    @Test
    void aQuarterOfTheRaysThroughAnEdgeTouchItExactly() {
        double touching = BoxFamily.EDGE.queries(1, SIZE).stream().map(ExactBox::chord)
            .filter(chord -> chord.filter(c -> c.near().equals(c.far())).isPresent()).count();
        assertEquals(0.25, touching / SIZE, 0.1);
    }
}
