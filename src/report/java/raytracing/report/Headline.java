package raytracing.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import raytracing.timed.Spread;

/** What the report comes to, in a few sentences. */
final class Headline {
    private Headline() {
    }

    static List<String> of(List<SceneStudy> studies) {
        List<String> sentences = new ArrayList<>();
        if (studies.size() == 1) {
            studies.get(0).families().forEach(family -> sentences.add(Verdict.of(family).sentences()));
            return sentences;
        }
        sentence(studies, Family.SHADOWS, "For the error of exact shadows, sampling takes ",
            " scenes with soft shadows").ifPresent(sentences::add);
        sentence(studies, Family.EDGES, "For the error of 4 x 4 rays at edges, rays in every pixel take ",
            " scenes").ifPresent(sentences::add);
        return sentences;
    }

    private static Optional<String> sentence(List<SceneStudy> studies, Family family, String begin, String end) {
        List<Verdict> verdicts = studies.stream().flatMap(study -> study.family(family).stream()).map(Verdict::of)
            .filter(verdict -> verdict.timesAsLong().isPresent()).toList();
        String atLeast = verdicts.stream().anyMatch(Verdict::isBound) ? "at least " : "";
        return Spread.of(verdicts.stream().flatMap(verdict -> verdict.timesAsLong().stream()).toList())
            .map(spread -> begin + atLeast + Shown.factor(spread.median()) + " as long: the median of "
                + verdicts.size() + end + ", from " + Shown.number(spread.least()) + " to "
                + Shown.number(spread.most()) + ".");
    }
}
