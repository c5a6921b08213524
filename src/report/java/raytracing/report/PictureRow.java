package raytracing.report;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The settings of a family whose pictures are shown side by side. */
final class PictureRow {
    private PictureRow() {
    }

    static List<Measurement> of(FamilyStudy study, int shadowRoot) {
        Stream<Optional<Measurement>> chosen = study.family() == Family.SHADOWS
            ? Stream.of(study.of(Series.SAMPLED, 1), study.of(Series.SAMPLED, shadowRoot),
                study.of(Series.SAMPLED, Family.MOST_SHADOW_ROOT), study.of(Series.EXACT, 1))
            : Stream.of(study.of(Series.ONE_RAY, 1), study.of(Series.AT_EDGES, 2), study.of(Series.AT_EDGES, 4),
                study.of(Series.EVERYWHERE, 4));
        return chosen.flatMap(Optional::stream).distinct().toList();
    }
}
