package raytracing.numerics;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/** Queries of a family with their exact answers, to judge any formula by. */
public final class Sample {
    private final List<Query> queries;
    private final List<ExactAnswer> answers;

    private Sample(List<Query> queries, List<ExactAnswer> answers) {
        this.queries = queries;
        this.answers = answers;
    }

    static Sample of(Shape shape, Queries drawn) {
        List<Query> queries = drawn.stream().toList();
        return new Sample(queries, queries.parallelStream().map(shape::exactAnswer).toList());
    }

    /**
     * What a formula got wrong.
     *
     * @param wrongShare share of wrong decisions, whether there is a crossing and which one: 0 to 1
     * @param worst largest error of a crossing rightly chosen, in ulps; not a number if there is none
     * @param median median error, likewise
     */
    public record Errors(double wrongShare, double worst, double median) {
    }

    /** Puts all queries to a formula. */
    public Errors errorsOf(Formula formula) {
        double[] errors = IntStream.range(0, queries.size()).mapToDouble(i -> error(formula, i)).toArray();
        double wrong = Arrays.stream(errors).filter(error -> error == ExactAnswer.WRONG_DECISION).count();
        double[] ofCrossings = IntStream.range(0, errors.length)
            .filter(i -> answers.get(i).wanted() < Formula.MISS && errors[i] < ExactAnswer.WRONG_DECISION)
            .mapToDouble(i -> errors[i]).sorted().toArray();
        return ofCrossings.length == 0 ? new Errors(wrong / errors.length, Double.NaN, Double.NaN)
            : new Errors(wrong / errors.length, ofCrossings[ofCrossings.length - 1],
                ofCrossings[ofCrossings.length / 2]);
    }

    private double error(Formula formula, int i) {
        return answers.get(i).errorInUlps(formula.firstCrossing(queries.get(i)));
    }

    /** Share of the queries whose ray meets its surface. */
    double shareOfHits() {
        return (double) answers.stream().filter(answer -> answer.wanted() < Formula.MISS).count() / answers.size();
    }

    /** Which query a formula answered worst, and how, for the message of a failure. */
    String worstAnswer(Formula formula) {
        int worst = IntStream.range(0, queries.size()).boxed()
            .max(Comparator.comparingDouble(i -> error(formula, i))).orElseThrow();
        return "wanted " + answers.get(worst).wanted() + ", found " + formula.firstCrossing(queries.get(worst))
            + " for " + queries.get(worst);
    }
}
