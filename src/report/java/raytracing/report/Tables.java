package raytracing.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Everything that was measured, in tables. */
final class Tables {
    private static final String ON_THE_FRONT = "●";
    private static final String RECOMMENDED = "◎";
    private static final String NOISE = " †";
    private static final String NONE = "-";

    private Tables() {
    }

    /** All settings of a family. */
    static Table settings(FamilyStudy study) {
        List<String> heads = List.of("setting", "frame, ms", "RMSE", "largest", "PSNR, dB", "off by > 1 step, %",
            "SSIM", "front");
        List<Measurement> front = study.front();
        return new Table("Frames: median (quartiles). ● not beaten in both time and error, ◎ and recommended. "
            + "† noise: quartiles far apart, or less time than a setting with less work.", heads,
            study.measurements().stream().map(measurement -> settingCells(study, measurement, front)).toList());
    }

    private static List<String> settingCells(FamilyStudy study, Measurement measurement, List<Measurement> front) {
        ErrorFigures error = measurement.error();
        String mark = measurement.equals(Recommendation.of(study).chosen()) ? RECOMMENDED : ON_THE_FRONT;
        boolean isBound = study.reference().hides(error.rootMeanSquare());
        return List.of(measurement.setting().title(),
            Shown.quartiles(measurement.milliseconds()) + (study.noisy().contains(measurement) ? NOISE : ""),
            (isBound ? "≤ " : "") + Shown.error(study.figures(measurement).error()), Shown.error(error.largest()),
            Shown.decibels(error.psnr()), Shown.percent(error.shareOff()), Shown.similarity(error.ssim()),
            front.contains(measurement) || mark.equals(RECOMMENDED) ? mark : "");
    }

    /** Exact shadows and sampled ones, scene by scene. */
    static Table shadows(List<SceneStudy> studies) {
        return new Table("Soft shadows, one ray a pixel. Times of a warm frame; errors: RMSE in linear light. "
            + "* extrapolated.",
            List.of("scene", "its own N", "frame, ms", "error", "exact: frame, ms", "error",
                "sampling at that error", "times as long", "recommended"),
            studies.stream().flatMap(study -> study.family(Family.SHADOWS).stream()
                .map(family -> shadowCells(study, family))).toList());
    }

    private static List<String> shadowCells(SceneStudy scene, FamilyStudy study) {
        Verdict verdict = Verdict.of(study);
        Measurement own = study.of(Series.SAMPLED, scene.shadowRoot()).orElseThrow();
        TimedError figures = study.figures(own);
        return List.of(scene.title(), String.valueOf(scene.shadowRoot()), Shown.number(figures.milliseconds()),
            Shown.error(figures.error()), Shown.number(verdict.figures().milliseconds()), verdict.shownError(),
            verdict.shownPlain(), verdict.shownTimesAsLong(), recommended(study));
    }

    private static String recommended(FamilyStudy study) {
        return study.hasErrors() ? Recommendation.of(study).chosen().setting().asked() : NONE;
    }

    /** How long each way to smooth edges takes for the same error, scene by scene. */
    static Table edges(List<SceneStudy> studies) {
        return new Table("Edges, with exact shadows: time of a warm frame that is right to half a step of 1/255, "
            + "RMSE 2.0e-3. * extrapolated; ≤ the coarsest setting is right to that already.",
            List.of("scene", "one ray: frame, ms", "off by, steps", "`--error`", "`--samples`", "everywhere",
                "`--samples` over `--error`", "everywhere over `--error`", "recommended"),
            studies.stream().flatMap(study -> study.family(Family.EDGES).stream()
                .map(family -> edgeCells(study, family))).toList());
    }

    private static List<String> edgeCells(SceneStudy scene, FamilyStudy study) {
        TimedError figures = study.figures(study.of(Series.ONE_RAY, 1).orElseThrow());
        Optional<EqualError.Time> limit = study.timeAt(Series.ERROR_LIMIT, Recommendation.AIM);
        Optional<EqualError.Time> edges = study.timeAt(Series.AT_EDGES, Recommendation.AIM);
        Optional<EqualError.Time> everywhere = study.timeAt(Series.EVERYWHERE, Recommendation.AIM);
        return List.of(scene.title(), Shown.number(figures.milliseconds()), Shown.steps(figures.error()),
            shown(limit), shown(edges), shown(everywhere), ratio(edges, limit), ratio(everywhere, limit),
            recommended(study));
    }

    static String shown(Optional<EqualError.Time> time) {
        return time.map(EqualError.Time::shown).orElse(NONE);
    }

    private static String ratio(Optional<EqualError.Time> one, Optional<EqualError.Time> other) {
        return one.flatMap(time -> other.map(limit -> Shown.number(time.milliseconds() / limit.milliseconds())))
            .orElse(NONE);
    }

    /** Shortcuts left out, with the scenes' own N. */
    static Table sampledSpeedUps(List<SceneStudy> studies) {
        return speedUps("Speed-ups with each scene's own N", studies, studies.stream()
            .map(SceneStudy::sampledSpeedUps).toList());
    }

    /** Shortcuts left out, with exact shadows. */
    static Table exactSpeedUps(List<SceneStudy> studies) {
        return speedUps("Speed-ups with exact shadows", studies, studies.stream()
            .map(SceneStudy::exactSpeedUps).toList());
    }

    private static Table speedUps(String title, List<SceneStudy> studies, List<List<SpeedUps.Row>> rowsOfScenes) {
        List<String> heads = Stream.of(Stream.of("scene", "all: frame, ms"),
            rowsOfScenes.get(0).stream().skip(1).map(SpeedUps.Row::title),
            Stream.of("most pixels changed")).flatMap(head -> head).toList();
        List<List<String>> rows = new ArrayList<>();
        for (int i = 0; i < studies.size(); i++) {
            rows.add(speedUpCells(studies.get(i).title(), rowsOfScenes.get(i)));
        }
        return new Table(title + ": a warm frame, median (quartiles), and how many times as long it takes without.",
            heads, rows);
    }

    private static List<String> speedUpCells(String scene, List<SpeedUps.Row> rows) {
        return Stream.of(Stream.of(scene, Shown.quartiles(rows.get(0).milliseconds())),
            rows.stream().skip(1).map(row -> Shown.number(row.timesAsLong())),
            Stream.of(change(rows))).flatMap(cell -> cell).toList();
    }

    private static String change(List<SpeedUps.Row> rows) {
        double changed = rows.stream().mapToDouble(SpeedUps.Row::shareChanged).max().orElse(0);
        double largest = rows.stream().mapToDouble(SpeedUps.Row::largestChange).max().orElse(0);
        return changed == 0 ? "none" : Shown.percent(changed) + " % by " + Shown.error(largest);
    }

    /** Whole processes. */
    static Table cold(List<SceneStudy> studies) {
        return new Table("Whole processes, cold: seconds from start to end, median (least - most).",
            Stream.concat(Stream.of("scene"), studies.get(0).coldRuns().stream().map(row ->
                row.options().isEmpty() ? "no options: its own N" : row.options())).toList(),
            studies.stream().map(study -> Stream.concat(Stream.of(study.title()), study.coldRuns().stream()
                .map(row -> row.seconds().shown(2))).toList()).toList());
    }
}
