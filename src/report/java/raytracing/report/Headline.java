package raytracing.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import raytracing.timed.Spread;

/** What the report comes to, in a few sentences that a user can act on. */
final class Headline {
    private Headline() {
    }

    /** With marks for code, as Markdown has them. */
    static List<String> of(List<SceneStudy> studies) {
        if (studies.size() == 1) {
            SceneStudy study = studies.get(0);
            return study.families().stream()
                .map(family -> Recommendation.of(family).sentences(study.shadowRoot())).toList();
        }
        List<String> sentences = new ArrayList<>();
        shadows(studies).ifPresent(sentences::add);
        sentences.add(edges(studies));
        return sentences;
    }

    private static Optional<String> shadows(List<SceneStudy> studies) {
        List<Double> times = new ArrayList<>();
        List<Double> errors = new ArrayList<>();
        long recommended = 0;
        boolean isBound = false;
        for (SceneStudy study : studies.stream().filter(one -> one.family(Family.SHADOWS).isPresent()).toList()) {
            FamilyStudy family = study.family(Family.SHADOWS).orElseThrow();
            TimedError own = family.figures(family.of(Series.SAMPLED, study.shadowRoot()).orElseThrow());
            TimedError exact = family.figures(family.of(Series.EXACT, 1).orElseThrow());
            times.add(exact.milliseconds() / own.milliseconds());
            if (exact.error() > 0) {
                errors.add(own.error() / exact.error());
            }
            isBound |= Verdict.of(family).isBound();
            recommended += Recommendation.of(family).chosen().setting().series() == Series.EXACT ? 1 : 0;
        }
        long exact = recommended;
        String atLeast = isBound ? "at least " : "";
        return Spread.of(times).flatMap(time -> Spread.of(errors).map(error ->
            "Compared with each scene's own N exact shadows " + Recommendation.asLong(time.median())
            + " and are " + atLeast + Shown.rough(error.median()) + " times closer, in the median of " + times.size()
            + " scenes with soft shadows: " + Setting.exact().asked() + ", which is recommended for " + exact
            + " of them."));
    }

    private static String edges(List<SceneStudy> studies) {
        List<FamilyStudy> families = studies.stream().flatMap(study -> study.family(Family.EDGES).stream()).toList();
        long recommended = families.stream().map(family -> Recommendation.of(family).chosen().setting().series())
            .filter(series -> series == Series.ERROR_LIMIT).count();
        return "For smooth edges that are right to half a step `--error` is the fastest in " + recommended + " of "
            + families.size() + " scenes" + times(families, Series.AT_EDGES, "; `--samples` takes ")
            + times(families, Series.EVERYWHERE, ", rays in every pixel take ") + " as long, in the median.";
    }

    /** How many times as long as an error limit another series takes to be right to half a step. */
    private static String times(List<FamilyStudy> families, Series series, String begin) {
        List<Double> factors = families.stream().flatMap(family -> family.timeAt(series, Recommendation.AIM).stream()
            .flatMap(other -> family.timeAt(Series.ERROR_LIMIT, Recommendation.AIM).stream()
                .map(limit -> other.milliseconds() / limit.milliseconds()))).toList();
        return begin + Spread.of(factors).map(spread -> Shown.rough(spread.median()) + " times").orElse("-");
    }
}
