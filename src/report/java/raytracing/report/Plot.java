package raytracing.report;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.knowm.xchart.AnnotationText;
import org.knowm.xchart.VectorGraphicsEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** Error against time on logarithmic axes: one line for each series, the front of the unbeaten behind them. */
final class Plot {
    static final int WIDTH = 540;
    static final int HEIGHT = 440;

    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 12);
    private static final Color NOTHING = new Color(255, 255, 255, 0);
    private static final BasicStroke HAIRLINE = new BasicStroke(0.6f);
    private static final BasicStroke THIN = new BasicStroke(1.2f);
    private static final BasicStroke THICK = new BasicStroke(5, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);

    /** Where a label stands beside its point: shares of the plot's height and of its width, which is about so. */
    private static final double LIFT = 0.02;
    private static final double CHARACTER = 6.4 / 440;
    private static final double DISTANCE = 10.0 / 440;

    private final FamilyStudy study;
    private final XYChart chart = new XYChartBuilder().width(WIDTH).height(HEIGHT)
        .xAxisTitle("time of a warm frame, ms").yAxisTitle("error: RMSE in linear light").build();
    private final LogarithmicRange times;
    private final LogarithmicRange errors;

    private Plot(FamilyStudy study) {
        this.study = study;
        List<TimedError> all = new ArrayList<>(visible(study.measurements()));
        all.add(study.reference().half());
        all.add(new TimedError(all.get(0).milliseconds(), study.reference().ownError()));
        times = LogarithmicRange.around(all.stream().map(TimedError::milliseconds).toList());
        errors = LogarithmicRange.around(all.stream().map(TimedError::error).filter(error -> error > 0).toList());
    }

    /** A picture of a study that has errors. */
    static Svg of(FamilyStudy study) throws IOException {
        Plot plot = new Plot(study);
        plot.style();
        plot.addFront();
        plot.addOwnError();
        for (Series series : Series.values()) {
            plot.add(series);
        }
        plot.addHalf();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        VectorGraphicsEncoder.saveVectorGraphic(plot.chart, bytes, VectorGraphicsEncoder.VectorGraphicsFormat.SVG);
        return new Svg(bytes.toString(StandardCharsets.UTF_8));
    }

    private void style() {
        XYStyler styler = chart.getStyler();
        styler.setXAxisLogarithmic(true).setYAxisLogarithmic(true);
        styler.setXAxisMin(times.least()).setXAxisMax(times.most()).setYAxisMin(errors.least())
            .setYAxisMax(errors.most());
        styler.setDecimalPattern("0.#########");
        styler.setAxisTitleFont(FONT).setAxisTickLabelsFont(FONT).setAxisTickLabelsColor(Ink.TEXT.color());
        styler.setXAxisTitleColor(Ink.TEXT.color());
        styler.setYAxisGroupTitleColor(0, Ink.TEXT.color());
        styler.setAxisTickMarksColor(Ink.FRAME.color()).setAxisTickMarksStroke(HAIRLINE);
        styler.setPlotGridLinesColor(Ink.GRID.color()).setPlotGridLinesStroke(HAIRLINE);
        styler.setPlotMargin(0).setPlotContentSize(1).setPlotBorderColor(Ink.FRAME.color());
        styler.setPlotBackgroundColor(NOTHING).setChartBackgroundColor(NOTHING).setChartFontColor(Ink.TEXT.color());
        styler.setLegendPosition(Styler.LegendPosition.InsideNE).setLegendFont(FONT).setLegendPadding(6);
        styler.setLegendBackgroundColor(NOTHING).setLegendBorderColor(NOTHING);
        styler.setAnnotationTextFont(FONT).setAnnotationTextFontColor(Ink.TEXT.color());
        styler.setDefaultSeriesRenderStyle(XYSeries.XYSeriesRenderStyle.Line);
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
            steps.add(new TimedError(times.most(), steps.get(steps.size() - 1).error()));
            line("Pareto front", steps, Ink.FRONT, THICK, SeriesMarkers.NONE);
        }
    }

    private void addOwnError() {
        double error = study.reference().ownError();
        if (error > 0) {
            line("the reference's own error",
                List.of(new TimedError(times.least(), error), new TimedError(times.most(), error)),
                Ink.TEXT, HAIRLINE, SeriesMarkers.NONE);
        }
    }

    private void add(Series series) {
        List<Measurement> measurements = study.of(series).stream()
            .filter(measurement -> study.figures(measurement).error() > 0).toList();
        if (measurements.isEmpty()) {
            return;
        }
        measurements.forEach(this::addWhisker);
        line(series.title(), visible(measurements), series.ink(), THIN, marker(series));
        label(measurements.get(0));
        if (measurements.size() > 1) {
            label(measurements.get(measurements.size() - 1));
        }
    }

    /** From quartile to quartile of the times. */
    private void addWhisker(Measurement measurement) {
        double error = study.figures(measurement).error();
        line(measurement.setting().title() + ", quartiles", List.of(
                new TimedError(times.clamped(measurement.milliseconds().lower()), error),
                new TimedError(times.clamped(measurement.milliseconds().upper()), error)),
            measurement.setting().series().ink(), HAIRLINE, SeriesMarkers.NONE).setShowInLegend(false);
    }

    /** The clever series below its points on the left, the others on the right: neither writes over the other. */
    private void label(Measurement measurement) {
        TimedError point = study.figures(measurement);
        String text = measurement.setting().title()
            + (study.reference().hides(measurement.error().rootMeanSquare()) ? ", or less" : "");
        double half = text.length() * CHARACTER / 2;
        int side = measurement.setting().series() == study.family().clever() ? -1 : 1;
        double middle = times.moved(point.milliseconds(), side * (half + DISTANCE));
        chart.addAnnotation(new AnnotationText(text,
            Math.min(Math.max(middle, times.moved(times.least(), half)), times.moved(times.most(), -half)),
            errors.moved(point.error(), side * LIFT), false));
    }

    /** Plain work goes on to the halves of the reference. */
    private void addHalf() {
        TimedError half = study.reference().half();
        Ink ink = study.family().plain().ink();
        if (half.error() > 0) {
            List<TimedError> plain = visible(study.of(study.family().plain()));
            line("on to the half", List.of(plain.get(plain.size() - 1), half), ink, HAIRLINE, SeriesMarkers.NONE)
                .setShowInLegend(false);
            line("a half of the reference", List.of(half), ink, THIN, SeriesMarkers.PLUS);
        }
    }

    private XYSeries line(String title, List<TimedError> points, Ink ink, BasicStroke stroke, Marker marker) {
        XYSeries series = chart.addSeries(title, array(points, TimedError::milliseconds),
            array(points, TimedError::error));
        series.setMarker(marker).setMarkerColor(ink.color());
        series.setLineColor(ink.color()).setLineStyle(stroke);
        return series;
    }

    private static double[] array(List<TimedError> points, ToDoubleFunction<TimedError> figure) {
        return points.stream().mapToDouble(figure).toArray();
    }

    private List<TimedError> visible(List<Measurement> measurements) {
        return measurements.stream().map(study::figures).filter(point -> point.error() > 0).toList();
    }

    private static Marker marker(Series series) {
        return switch (series.shape()) {
            case CIRCLE -> SeriesMarkers.CIRCLE;
            case DIAMOND -> SeriesMarkers.DIAMOND;
            case SQUARE -> SeriesMarkers.SQUARE;
        };
    }
}
