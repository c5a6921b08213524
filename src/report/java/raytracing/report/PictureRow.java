package raytracing.report;

import java.util.List;

/** The settings of a family whose pictures are shown side by side. */
final class PictureRow {
    private PictureRow() {
    }

    static List<Setting> settings(Family family, int shadowRoot) {
        List<Setting> settings = family == Family.SHADOWS
            ? List.of(Setting.sampled(1), Setting.sampled(shadowRoot), Setting.sampled(Family.MOST_SHADOW_ROOT),
                Setting.exact())
            : List.of(Setting.oneRay(), Setting.atEdges(4), Setting.everywhere(4), Setting.errorLimit(1));
        return settings.stream().distinct().toList();
    }

    static List<Measurement> of(FamilyStudy study) {
        return study.measurements().stream().filter(measurement -> measurement.illustration().isPresent()).toList();
    }
}
