package raytracing.report;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * What a user of this scene is told to ask for: of the settings that the command line offers and that are right to half a
 * step, the fastest; of those that are about as fast, the closest.
 *
 * @param study of which scene and family
 * @param chosen the setting
 */
record Recommendation(FamilyStudy study, Measurement chosen) {
    /** Half a step of 1/255, as a root mean square over the picture: its 8 bits lose a little less by themselves. */
    static final double AIM = 0.5 / 255;

    /** Times that differ by no more than this factor are told as the same. */
    private static final double AS_LONG = 1.1;

    static Recommendation of(FamilyStudy study) {
        List<Measurement> offered = study.measurements().stream()
            .filter(measurement -> measurement.setting().options().isPresent()).toList();
        double least = offered.stream().mapToDouble(one -> study.figures(one).error()).min().orElseThrow();
        double most = Math.max(AIM, least);
        List<Measurement> right = offered.stream().filter(one -> study.figures(one).error() <= most).toList();
        double fastest = right.stream().mapToDouble(one -> one.milliseconds().median()).min().orElseThrow();
        return new Recommendation(study, right.stream()
            .filter(one -> one.milliseconds().median() <= AS_LONG * fastest)
            .min(Comparator.<Measurement>comparingDouble(one -> study.figures(one).error())
                .thenComparing(one -> one.milliseconds().median())).orElseThrow());
    }

    /** One sentence or two to act on. */
    String sentences(int shadowRoot) {
        if (!study.hasErrors()) {
            return "All settings draw the same picture, to the last bit.";
        }
        return (study.family() == Family.SHADOWS ? shadowSentences(shadowRoot) : edgeSentences()) + noiseSentence();
    }

    private String shadowSentences(int shadowRoot) {
        Measurement own = study.of(Series.SAMPLED, shadowRoot).orElseThrow();
        Measurement exact = study.of(Series.EXACT, 1).orElseThrow();
        String compared = "exact shadows " + asLong(ratio(exact, own)) + " and are " + closer(own, exact);
        if (chosen.equals(exact)) {
            return "At this scene's own N = " + shadowRoot + " " + compared + ": " + chosen.setting().asked() + ".";
        }
        String first = chosen.equals(own)
            ? "This scene's own N = " + shadowRoot + " is right to " + steps(chosen) + ": no option is needed."
            : "For this scene N = " + Shown.plain(chosen.setting().number()) + " is right to " + steps(chosen) + ": "
                + chosen.setting().asked() + ".";
        return first + " Compared with its own N, " + compared + ".";
    }

    private double ratio(Measurement one, Measurement other) {
        return one.milliseconds().median() / other.milliseconds().median();
    }

    static String asLong(double ratio) {
        if (ratio <= AS_LONG && ratio >= 1 / AS_LONG) {
            return "take as long";
        }
        return ratio < 1 ? "take " + Shown.rough(ratio) + " of the time" : "take " + Shown.rough(ratio) + " times as long";
    }

    private String closer(Measurement own, Measurement exact) {
        double error = study.figures(exact).error();
        if (error == 0) {
            return "free of error";
        }
        double factor = study.figures(own).error() / error;
        return factor <= AS_LONG ? "as close"
            : (study.reference().hides(exact.error().rootMeanSquare()) ? "at least " : "") + Shown.rough(factor)
                + " times closer";
    }

    private String edgeSentences() {
        double error = study.figures(chosen).error();
        boolean isRight = error <= AIM;
        String first = isRight
            ? "The fastest way to smooth edges that is right to half a step is " + chosen.setting().asked()
            : "No setting is right to half a step; the closest is " + chosen.setting().asked();
        return first + ": " + Shown.duration(chosen.milliseconds().median()) + " a frame, off by " + steps(chosen) + "."
            + others(error);
    }

    private String others(double error) {
        String samples = chosen.setting().series() == Series.ERROR_LIMIT
            ? factor(Series.AT_EDGES, error).map(factor -> "`--samples` takes " + factor + " as long").orElse("")
            : factor(Series.ERROR_LIMIT, error).map(factor -> "`--error` takes " + factor + " as long").orElse("");
        String everywhere = factor(Series.EVERYWHERE, error)
            .map(factor -> "rays in every pixel " + factor).orElse("");
        return samples.isEmpty() || everywhere.isEmpty() || chosen.setting().series() == Series.ONE_RAY ? ""
            : " For as little error " + samples + ", " + everywhere + ".";
    }

    private Optional<String> factor(Series series, double error) {
        return study.timeAt(series, error)
            .map(time -> Shown.rough(time.milliseconds() / chosen.milliseconds().median()) + " times");
    }

    private String steps(Measurement measurement) {
        boolean isBound = study.reference().hides(measurement.error().rootMeanSquare());
        return Shown.steps(study.figures(measurement).error()) + " steps" + (isBound ? " or less" : "");
    }

    private String noiseSentence() {
        return study.noisy().contains(chosen) ? " Its time is uncertain: see † below." : "";
    }
}
