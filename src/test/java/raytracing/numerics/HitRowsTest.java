package raytracing.numerics;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import raytracing.math.ExactVector;
import raytracing.math.Vector;

/**
 * Hit points and normals of the product against tables of exact answers, at the best of their three levels. How far a
 * point is from its surface is worked out in exact arithmetic. Skips, and says so, where the tables are missing.
 */
class HitRowsTest {
    private static final double EPS = Math.ulp(1.0);

    /** A row that asks for a hit, and the product's answer to it; a wrong one is another test's concern. */
    private record RowHit(Row row, Query query, double t) {
        Vector point() {
            return ProductAlgorithms.hitPoint(row.shape().surface(query), query, t);
        }

        Vector normal() {
            return ProductAlgorithms.outwardNormal(row.shape().surface(query), query, t);
        }

        /** |o| + t |d|: what the rounding of a hit point is measured by. */
        double way() {
            return query.origin().length() + t * query.direction().length();
        }

        ExactVector exactPoint() {
            return ExactVector.of(point());
        }
    }

    private static Stream<RowHit> hits(Shape shape) {
        List<RowHit> hits = Row.of(shape).stream().filter(Row::isHit)
            .map(row -> new RowHit(row, row.query(), row.foundByTheProduct())).toList();
        assertTrue(hits.size() > 200, "too few hits to mean anything");
        return hits.stream().filter(hit -> hit.row.answer().errorInUlps(hit.t) < ExactAnswer.WRONG_DECISION);
    }

    private static void assertBounded(Shape shape, Function<RowHit, Double> error, Function<RowHit, Double> bound) {
        Failures.assertNone(hits(shape)
            .filter(hit -> !(error.apply(hit) <= bound.apply(hit)))
            .map(hit -> hit.row.id() + ": off by " + error.apply(hit) + ", allowed " + bound.apply(hit)));
    }

    private static double largestPart(Vector v) {
        return Math.max(Math.abs(v.x()), Math.max(Math.abs(v.y()), Math.abs(v.z())));
    }

    @ParameterizedTest
    @EnumSource
    void hitPointsAreWhereTheRayIs(Shape shape) {
        assertBounded(shape, hit -> largestPart(hit.point().minus(hit.row.vector("p"))), hit -> 32 * EPS * hit.way());
    }

    @Test
    void hitPointsAreOnTheSphere() {
        assertBounded(Shape.SPHERE, HitRowsTest::distanceFromSphere, hit -> {
            Vector point = hit.point();
            Vector centre = hit.query.vector();
            double radius = hit.query.scalar();
            double must = 4 * Math.max(radius, Math.max(largestPart(point), largestPart(centre)));
            double best = 2 * (point.length() + Math.min(hit.way(), centre.length() + radius));
            return EPS * Math.min(must, best);
        });
    }

    private static double distanceFromSphere(RowHit hit) {
        return ExactSphere.distance(hit.exactPoint(), ExactVector.of(hit.query.vector()),
            new BigDecimal(hit.query.scalar())).doubleValue();
    }

    @Test
    void hitPointsAreOnThePlane() {
        assertBounded(Shape.PLANE, HitRowsTest::distanceFromPlane, hit -> {
            double offset = Math.abs(hit.query.scalar()) / hit.query.vector().length();
            return 4 * EPS * Math.max(hit.point().length(), offset);
        });
    }

    private static double distanceFromPlane(RowHit hit) {
        return ExactPlane.distance(hit.exactPoint(), ExactVector.of(hit.query.vector()),
            new BigDecimal(hit.query.scalar())).doubleValue();
    }

    @Test
    void hitPointsAreOnTheFaceThatTheNormalNames() {
        assertBounded(Shape.BOX, HitRowsTest::distanceFromFace,
            hit -> 2 * EPS * (hit.query.vector().length() + hit.query.scalar() / 2));
    }

    private static double distanceFromFace(RowHit hit) {
        ExactVector fromCentre = hit.exactPoint().minus(ExactVector.of(hit.query.vector()));
        return ExactBox.distanceToFace(fromCentre, hit.normal(), ExactBox.half(hit.query.scalar())).doubleValue();
    }

    /** Only the way from centre to origin counts: where both lie in the world does not. */
    @Test
    void normalsOfSpheresPointOutwards() {
        assertBounded(Shape.SPHERE, hit -> largestPart(hit.normal().minus(hit.row.vector("n"))), hit -> {
            double way = hit.query.origin().minus(hit.query.vector()).length() + hit.t * hit.query.direction().length();
            return 4 * EPS * (1 + way / hit.query.scalar());
        });
    }

    @Test
    void normalsOfPlanesAreUnit() {
        assertBounded(Shape.PLANE, hit -> largestPart(hit.normal().minus(hit.row.vector("n"))), hit -> 2 * EPS);
    }

    @Test
    void normalsOfBoxesAreThoseOfTheFaceHit() {
        Failures.assertNone(hits(Shape.BOX)
            .filter(hit -> !List.of(hit.row.text("faces").split("\\|")).contains(face(hit.normal())))
            .map(hit -> hit.row.id() + ": wanted " + hit.row.text("faces") + ", found " + hit.normal()));
    }

    /** As the table writes it; what is not exactly an axis is no face. */
    private static String face(Vector normal) {
        return Stream.of("+x", "-x", "+y", "-y", "+z", "-z")
            .filter(face -> outward(face).minus(normal).isZero()).findFirst().orElse("none");
    }

    private static Vector outward(String face) {
        return Axes.withPart(Vector.ZERO, "xyz".indexOf(face.charAt(1)), face.charAt(0) == '+' ? 1 : -1);
    }
}
