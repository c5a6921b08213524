package raytracing.report;

import java.util.Optional;
import raytracing.Quantiles;

/**
 * What one setting made of a scene.
 *
 * @param setting how it was drawn
 * @param refinedShare how much of the picture got more than one ray, from 0 to 1
 * @param milliseconds of warm frames
 * @param error against the reference
 * @param illustration of a setting whose picture is shown
 */
record Measurement(Setting setting, double refinedShare, Quantiles milliseconds, ErrorFigures error,
                   Optional<Illustration> illustration) {
}
