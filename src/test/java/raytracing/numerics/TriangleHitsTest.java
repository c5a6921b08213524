package raytracing.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import raytracing.math.ExactVector;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.surface.Departure;
import raytracing.surface.Hit;
import raytracing.surface.HitRecord;
import raytracing.surface.RayRecord;
import raytracing.surface.Segment;

/** Hit points and normals of triangles, against exact arithmetic. */
class TriangleHitsTest {
    private static final long SEED = 97;
    private static final int SIZE = 2_000;

    /** Of each coordinate of a unit normal. */
    private static final double NORMAL_ERROR = 2 * Math.ulp(1.0);

    /** A ray that meets its triangle, and what the product says about the place. */
    private record Met(TriangleQuery query, BigDecimal t, HitRecord hit) {
        static Optional<Met> of(TriangleQuery query) {
            return query.exact().map(exact -> new Met(query, exact.value(),
                HitRecord.at(query.triangle(), RayRecord.of(query.ray()), query.found(), 0)));
        }

        /** The largest coordinate from the real crossing to the hit point. */
        double pointError() {
            return largest(ExactVector.of(hit.point())
                .minus(ExactVector.of(query.origin()).plus(t, ExactVector.of(query.direction()))));
        }

        double normalError() {
            ExactVector normal = exactNormal();
            BigDecimal length = normal.length();
            ExactVector unit = new ExactVector(normal.x().divide(length, ExactVector.DIGITS),
                normal.y().divide(length, ExactVector.DIGITS), normal.z().divide(length, ExactVector.DIGITS));
            return Math.min(largest(ExactVector.of(hit.normal()).minus(unit)),
                largest(ExactVector.of(hit.normal()).plus(BigDecimal.ONE, unit)));
        }

        private ExactVector exactNormal() {
            ExactVector a = ExactVector.of(query.a());
            ExactVector u = ExactVector.of(query.b()).minus(a);
            ExactVector v = ExactVector.of(query.c()).minus(a);
            return new ExactVector(u.y().multiply(v.z()).subtract(u.z().multiply(v.y())),
                u.z().multiply(v.x()).subtract(u.x().multiply(v.z())), u.x().multiply(v.y()).subtract(u.y().multiply(v.x())));
        }

        private static double largest(ExactVector v) {
            return v.x().abs().max(v.y().abs()).max(v.z().abs()).doubleValue();
        }

        /** The hit's normal points to the side from which the triangle is seen. */
        boolean isSeenFromItsSide() {
            ExactVector normal = exactNormal();
            Vector direction = query.direction();
            boolean seenFromAbove = normal.dot(ExactVector.of(direction)).signum() < 0;
            return ExactVector.of(hit.normal()).dot(normal).signum() > 0 == seenFromAbove
                && (hit.side() == Departure.OUTWARD) == seenFromAbove;
        }
    }

    private static List<Met> hits(TriangleFamily family) {
        List<Met> hits = family.queries(SEED, SIZE).parallelStream().flatMap(query -> Met.of(query).stream()).toList();
        assertTrue(hits.size() > SIZE / 10, hits.size() + " hits");
        return hits;
    }

    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = {"ANY_UNIT", "ENDS", "TINY_DIRECTION"})
    void hitPointsAreWhereTheRayIsWithinTheirError(TriangleFamily family) {
        Failures.assertNone(hits(family).stream().filter(met -> met.pointError() > met.hit.pointError())
            .map(met -> met.pointError() + " beyond " + met.hit.pointError() + ": " + met.query));
    }

    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = {"ENDS"})
    void normalsAreUnitAndAtARightAngleToTheEdges(TriangleFamily family) {
        Failures.assertNone(hits(family).stream().filter(met -> !(met.normalError() <= NORMAL_ERROR))
            .map(met -> met.normalError() + ": " + met.query));
    }

    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = {"ON_IT", "ON_THE_PLANE", "IN_ITS_PLANE"})
    void normalsPointToWhereTheRayCameFrom(TriangleFamily family) {
        Failures.assertNone(hits(family).stream().filter(met -> !met.isSeenFromItsSide()).map(met -> met.query.toString()));
    }

    /** Ends before, at and behind the hit, or far away. */
    private static Vector end(TriangleQuery query, SplittableRandom random) {
        double factor = switch (random.nextInt(4)) {
            case 0 -> 1;
            case 1 -> 1 + Math.scalb(random.nextDouble(-1, 1), -random.nextInt(54));
            case 2 -> Math.scalb(random.nextDouble(-1, 1), random.nextInt(60));
            default -> random.nextDouble(0, 4);
        };
        return Vectors.plus(query.origin(), factor * query.found(), query.direction());
    }

    /** A light on the triangle itself is on neither side. */
    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = {"ON_IT", "ON_THE_PLANE", "IN_ITS_PLANE", "ENDS"})
    void aLineFromAHitCrossesTheTriangleIfItEndsBehindIt(TriangleFamily family) {
        SplittableRandom random = new SplittableRandom(SEED);
        int behind = 0;
        for (Met met : hits(family)) {
            Vector end = end(met.query, random);
            ExactTriangle exact = ExactTriangle.of(met.query.triangle());
            boolean isBehind = exact.side(ExactPoint.of(end)) == -exact.side(ExactPoint.of(met.query.origin()));
            Segment line = new Segment();
            Hit hit = met.hit.toHit();
            line.connect(hit.origin(), end.x(), end.y(), end.z(), 0);
            assertEquals(isBehind, met.query.triangle().isCrossedFrom(hit, line), () -> end + ", " + met.query);
            behind += isBehind ? 1 : 0;
        }
        assertTrue(behind > SIZE / 40, behind + " ends behind");
    }
}
