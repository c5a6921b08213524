package raytracing.report;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** Error against time: one line for each series, the front of the unbeaten behind them, and a ring around what is best. */
final class Plot {
    private final FamilyStudy study;
    private final ErrorChart chart;

    private Plot(FamilyStudy study) {
        this.study = study;
        List<TimedError> all = new ArrayList<>(visible(study.measurements()));
        all.add(study.reference().half());
        all.add(new TimedError(all.get(0).milliseconds(), study.reference().ownError()));
        all.add(new TimedError(all.get(0).milliseconds(), Recommendation.AIM));
        chart = new ErrorChart("time of a warm frame, ms",
            LogarithmicRange.around(all.stream().map(TimedError::milliseconds).toList()),
            LogarithmicRange.around(all.stream().map(TimedError::error).filter(error -> error > 0).toList()));
    }

    /** A picture of a study that has errors. */
    static Svg of(FamilyStudy study) throws IOException {
        Plot plot = new Plot(study);
        plot.addFront();
        plot.addRecommended();
        for (Series series : Series.values()) {
            plot.add(series);
        }
        plot.addHalf();
        plot.addLevels();
        return plot.chart.svg();
    }

    /** A step down at each of the unbeaten: on the line, nothing is to be had for less. */
    private void addFront() {
        List<TimedError> steps = new ArrayList<>();
        for (TimedError point : visible(study.front())) {
            if (!steps.isEmpty()) {
                steps.add(new TimedError(point.milliseconds(), steps.get(steps.size() - 1).error()));
            }
            steps.add(point);
        }
        if (!steps.isEmpty()) {
            steps.add(new TimedError(chart.times().most(), steps.get(steps.size() - 1).error()));
            chart.line("Pareto front", steps, Ink.FRONT, ErrorChart.THICK, SeriesMarkers.NONE);
        }
    }

    private void addRecommended() {
        Measurement chosen = Recommendation.of(study).chosen();
        if (study.figures(chosen).error() > 0) {
            chart.ring("recommended: " + chosen.setting().asked().replace("`", ""), study.figures(chosen));
        }
    }

    private void addLevels() {
        chart.level("half a step of 1/255", Recommendation.AIM, ErrorChart.DASHED);
        if (study.reference().ownError() > 0) {
            chart.level("the reference's own error", study.reference().ownError(), ErrorChart.HAIRLINE);
        }
    }

    private void add(Series series) {
        List<Measurement> measurements = study.of(series).stream()
            .filter(measurement -> study.figures(measurement).error() > 0).toList();
        if (measurements.isEmpty()) {
            return;
        }
        measurements.forEach(measurement -> chart.whisker(measurement.setting().title() + ", quartiles",
            measurement.milliseconds().lower(), measurement.milliseconds().upper(), study.figures(measurement).error(),
            series.ink()));
        chart.line(series.title(), visible(measurements), series.ink(), ErrorChart.THIN, ErrorChart.marker(series.shape()));
        if (!Series.AFTER_ONE_RAY.contains(series)) {
            label(measurements.get(0));
        }
        if (measurements.size() > 1) {
            label(measurements.get(measurements.size() - 1));
        }
    }

    /** The clever series below its points on the left, the others on the right: neither writes over the other. */
    private void label(Measurement measurement) {
        chart.label(measurement.setting().title()
                + (study.reference().hides(measurement.error().rootMeanSquare()) ? ", or less" : ""),
            study.figures(measurement), measurement.setting().series() == study.family().clever() ? -1 : 1);
    }

    /** Plain work goes on to the halves of the reference. */
    private void addHalf() {
        TimedError half = study.reference().half();
        Ink ink = study.family().plain().ink();
        if (half.error() > 0) {
            List<TimedError> plain = visible(study.of(study.family().plain()));
            chart.line("on to the half", List.of(plain.get(plain.size() - 1), half), ink, ErrorChart.HAIRLINE,
                SeriesMarkers.NONE).setShowInLegend(false);
            chart.line("a half of the reference", List.of(half), ink, ErrorChart.THIN, SeriesMarkers.PLUS);
        }
    }

    private List<TimedError> visible(List<Measurement> measurements) {
        return measurements.stream().map(study::figures).filter(point -> point.error() > 0).toList();
    }
}
