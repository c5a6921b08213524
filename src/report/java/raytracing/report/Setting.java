package raytracing.report;

import java.util.List;
import java.util.Optional;
import raytracing.render.ErrorLimit;
import raytracing.render.PixelGrid;
import raytracing.render.PixelSampling;
import raytracing.render.RenderSettings;
import raytracing.shadow.ShadowMethod;

/**
 * One way to draw any scene.
 *
 * @param series what it is one of
 * @param number its place there
 * @param shadows how soft shadows are found
 * @param sampling how many rays of the eye a pixel gets
 * @param options what asks the program for it on the command line; nothing where there is no such option
 */
record Setting(Series series, double number, ShadowMethod shadows, PixelSampling sampling,
               Optional<List<String>> options) {
    private static final List<String> EXACT_SHADOWS = List.of("--shadows", "exact");

    /** The exercise's N x N shadow rays. */
    static Setting sampled(int root) {
        return new Setting(Series.SAMPLED, root, ShadowMethod.Sampled.withRoot(root), PixelGrid.ONE_RAY,
            Optional.of(List.of("--shadows", "sampled", "--shadow-rays", String.valueOf(root))));
    }

    /** What sampled shadows come to as N grows. */
    static Setting exact() {
        return new Setting(Series.EXACT, 1, new ShadowMethod.Exact(), PixelGrid.ONE_RAY,
            Optional.of(EXACT_SHADOWS));
    }

    /** The same picture as {@link #exact}, where it is judged by its edges. */
    static Setting oneRay() {
        return new Setting(Series.ONE_RAY, 1, new ShadowMethod.Exact(), PixelGrid.ONE_RAY,
            Optional.of(EXACT_SHADOWS));
    }

    /** More rays for the pixels at edges, with exact shadows. */
    static Setting atEdges(int root) {
        return new Setting(Series.AT_EDGES, root, new ShadowMethod.Exact(),
            new PixelGrid(root, PixelGrid.Where.EDGES),
            Optional.of(List.of("--shadows", "exact", "--samples", String.valueOf(root))));
    }

    /** More rays for all pixels, with exact shadows. */
    static Setting everywhere(int root) {
        return new Setting(Series.EVERYWHERE, root, new ShadowMethod.Exact(),
            new PixelGrid(root, PixelGrid.Where.EVERYWHERE), Optional.empty());
    }

    /** As many rays for each pixel as its error needs, which is to stay below so many steps of 1/255; exact shadows. */
    static Setting errorLimit(double steps) {
        return new Setting(Series.ERROR_LIMIT, steps, new ShadowMethod.Exact(), new ErrorLimit(steps),
            Optional.of(List.of("--error", Shown.plain(steps))));
    }

    /** How a user asks for it. */
    String asked() {
        return "`" + String.join(" ", options.orElseThrow()) + "`";
    }

    /** How much work it is, to be compared within its series: of more rays, or of a smaller error. */
    double work() {
        return series == Series.ERROR_LIMIT ? -number : number;
    }

    String title() {
        return series.settingTitle(number);
    }

    RenderSettings in(RenderSettings settings) {
        return settings.withShadowMethod(shadows).withSampling(sampling);
    }
}
