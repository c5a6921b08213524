package raytracing.report;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
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

/** Error against time on logarithmic axes. */
final class ErrorChart {
    static final BasicStroke HAIRLINE = new BasicStroke(0.6f);
    static final BasicStroke THIN = new BasicStroke(1.2f);
    static final BasicStroke THICK = new BasicStroke(5, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    static final BasicStroke DASHED = new BasicStroke(0.8f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1,
        new float[] {5, 4}, 0);

    private static final int WIDTH = 540;
    private static final int HEIGHT = 440;
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 12);
    private static final Color NOTHING = new Color(255, 255, 255, 0);

    /** Where a label stands beside its point: shares of the plot's height and of its width, which is about so. */
    private static final double LIFT = 0.02;
    private static final double CHARACTER = 6.4 / 440;
    private static final double DISTANCE = 10.0 / 440;

    private final LogarithmicRange times;
    private final LogarithmicRange errors;
    private final XYChart chart;

    /**
     * Without any line.
     *
     * @param timeTitle what the times are, in milliseconds
     * @param times that are to be seen
     * @param errors that are to be seen, above 0
     */
    ErrorChart(String timeTitle, LogarithmicRange times, LogarithmicRange errors) {
        this.times = times;
        this.errors = errors;
        chart = new XYChartBuilder().width(WIDTH).height(HEIGHT)
            .xAxisTitle(timeTitle).yAxisTitle("error: RMSE in linear light").build();
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

    LogarithmicRange times() {
        return times;
    }

    /** A line through points, with their marks. */
    XYSeries line(String title, List<TimedError> points, Ink ink, BasicStroke stroke, Marker marker) {
        XYSeries series = chart.addSeries(title, array(points, TimedError::milliseconds),
            array(points, TimedError::error));
        series.setMarker(marker).setMarkerColor(ink.color());
        series.setLineColor(ink.color()).setLineStyle(stroke);
        return series;
    }

    private static double[] array(List<TimedError> points, ToDoubleFunction<TimedError> figure) {
        return points.stream().mapToDouble(figure).toArray();
    }

    /** From side to side at an error. */
    void level(String title, double error, BasicStroke stroke) {
        line(title, List.of(new TimedError(times.least(), error), new TimedError(times.most(), error)),
            Ink.TEXT, stroke, SeriesMarkers.NONE);
    }

    /** From time to time at an error, without a word. */
    void whisker(String title, double lower, double upper, double error, Ink ink) {
        line(title, List.of(new TimedError(times.clamped(lower), error), new TimedError(times.clamped(upper), error)),
            ink, HAIRLINE, SeriesMarkers.NONE).setShowInLegend(false);
    }

    /** A ring around a point. */
    void ring(String title, TimedError point) {
        line(title, List.of(point), Ink.TEXT, THIN, new Ring());
    }

    /** A name beside a point: below it on the left (-1), or above it on the right (1). */
    void label(String text, TimedError point, int side) {
        double half = text.length() * CHARACTER / 2;
        double middle = times.moved(point.milliseconds(), side * (half + DISTANCE));
        chart.addAnnotation(new AnnotationText(text,
            Math.min(Math.max(middle, times.moved(times.least(), half)), times.moved(times.most(), -half)),
            errors.moved(point.error(), side * LIFT), false));
    }

    /** How a shape is drawn at each point of a line. */
    static Marker marker(Series.Shape shape) {
        return switch (shape) {
            case CIRCLE -> SeriesMarkers.CIRCLE;
            case DIAMOND -> SeriesMarkers.DIAMOND;
            case SQUARE -> SeriesMarkers.SQUARE;
            case TRIANGLE -> SeriesMarkers.TRIANGLE_UP;
        };
    }

    Svg svg() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        VectorGraphicsEncoder.saveVectorGraphic(chart, bytes, VectorGraphicsEncoder.VectorGraphicsFormat.SVG);
        return new Svg(bytes.toString(StandardCharsets.UTF_8));
    }

    /** Leaves the mark inside it to be seen. */
    private static final class Ring extends Marker {
        private static final int EDGE = 18;

        @Override
        public void paint(Graphics2D graphics, double x, double y, int markerSize) {
            graphics.setStroke(new BasicStroke(1.6f));
            graphics.drawOval((int) Math.round(x) - EDGE / 2, (int) Math.round(y) - EDGE / 2, EDGE, EDGE);
        }
    }
}
