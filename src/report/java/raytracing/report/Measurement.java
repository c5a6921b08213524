package raytracing.report;

import raytracing.Quantiles;
import raytracing.film.Film;
import raytracing.render.Rendering;

/**
 * What one setting made of a scene.
 *
 * @param setting how it was drawn
 * @param rendering what came of it
 * @param milliseconds of warm frames
 * @param error against the reference
 */
record Measurement(Setting setting, Rendering rendering, Quantiles milliseconds, ErrorFigures error) {
    Film film() {
        return rendering.film();
    }
}
