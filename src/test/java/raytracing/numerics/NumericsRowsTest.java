package raytracing.numerics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import raytracing.math.Vector;

/**
 * Holds the product's crossings to tables of exact answers, at the best of their three levels: no wrong decision but
 * exactly on a boundary, and the bounds of {@link #allowedUlps}. Skips, and says so, where the tables are missing.
 */
class NumericsRowsTest {
    /** The tables' own bounds of the best level. At their level "should", a plane's would grow with its condition. */
    private static int allowedUlps(Shape shape) {
        return switch (shape) {
            case SPHERE -> 16;
            case PLANE -> 16;
            case BOX -> 2;
        };
    }

    @ParameterizedTest
    @EnumSource
    void everyDecisionIsRight(Shape shape) {
        assertNoneFails(shape, row -> !row.isOnBoundary(),
            row -> row.answer().errorInUlps(row.foundByTheProduct()) < ExactAnswer.WRONG_DECISION);
    }

    @ParameterizedTest
    @EnumSource
    void everyCrossingHasItsDigits(Shape shape) {
        assertNoneFails(shape, Row::isHit, row -> {
            double error = row.answer().errorInUlps(row.foundByTheProduct());
            return error <= allowedUlps(shape) || error == ExactAnswer.WRONG_DECISION;
        });
    }

    @ParameterizedTest
    @EnumSource
    void onABoundaryEitherAnswerIsRightButNoOther(Shape shape) {
        assertNoneFails(shape, Row::isOnBoundary, row -> {
            double found = row.foundByTheProduct();
            return found == Formula.MISS || row.boundaryCrossings()
                .anyMatch(crossing -> Math.abs(found - crossing) <= allowedUlps(shape) * Math.ulp(crossing));
        });
    }

    @Test
    void noRayLeaksBetweenTwoBoxesThatShareAFace() {
        Map<String, List<Row>> pairs = Row.of(Shape.BOX).stream().filter(row -> row.has("pair"))
            .collect(Collectors.groupingBy(row -> row.text("pair")));
        assertEquals(78, pairs.size());
        Failures.assertNone(pairs.entrySet().stream()
            .filter(pair -> pair.getValue().stream().allMatch(row -> row.foundByTheProduct() == Formula.MISS))
            .map(pair -> pair.getKey() + ": both boxes missed"));
    }

    /** Also in another order, when other queries have just been answered and the compiler has done its work. */
    @ParameterizedTest
    @EnumSource
    void theSameQuestionGetsTheSameAnswer(Shape shape) {
        List<Row> backwards = new ArrayList<>(Row.of(shape));
        List<Double> first = backwards.stream().map(Row::foundByTheProduct).collect(Collectors.toList());
        Collections.reverse(backwards);
        List<Double> second = backwards.stream().map(Row::foundByTheProduct).collect(Collectors.toList());
        Collections.reverse(second);
        assertEquals(first, second);
    }

    @ParameterizedTest
    @EnumSource
    void aMinusZeroIsAZero(Shape shape) {
        Formula ours = shape.ours().formula();
        Stream<Query> withZeros = Row.of(shape).stream().map(Row::query)
            .filter(query -> hasZero(query.direction()));
        Failures.assertNone(withZeros
            .filter(query -> ours.firstCrossing(query) != ours.firstCrossing(withOtherZeros(query)))
            .map(Query::toString));
    }

    private static boolean hasZero(Vector v) {
        return v.x() == 0 || v.y() == 0 || v.z() == 0;
    }

    private static Query withOtherZeros(Query query) {
        Vector d = query.direction();
        return query.withDirection(new Vector(otherZero(d.x()), otherZero(d.y()), otherZero(d.z())));
    }

    private static double otherZero(double part) {
        return part == 0 ? -part : part;
    }

    private static void assertNoneFails(Shape shape, Predicate<Row> which, Predicate<Row> law) {
        Failures.assertNone(Row.of(shape).stream().filter(which).filter(law.negate())
            .map(row -> row.id() + ": wanted " + row.answer().wanted() + ", found " + row.foundByTheProduct()));
    }
}
