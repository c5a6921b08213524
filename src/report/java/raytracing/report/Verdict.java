package raytracing.report;

import java.util.Optional;

/**
 * What comes of comparing the cleverest setting of a family with plain work at equal error.
 *
 * @param study of which scene and family
 * @param contender the setting
 * @param plain when plain work has as little error; nothing where that cannot be said
 */
record Verdict(FamilyStudy study, Measurement contender, Optional<EqualError.Time> plain) {
    /** Enough that edges look smooth, and what a user would choose first. */
    private static final int EYE_ROOT = 4;

    static Verdict of(FamilyStudy study) {
        int number = study.family() == Family.EDGES ? EYE_ROOT : 1;
        Measurement contender = study.of(study.family().clever(), number).orElseThrow();
        return new Verdict(study, contender, study.plainTimeAtErrorOf(contender));
    }

    TimedError figures() {
        return study.figures(contender);
    }

    boolean isBound() {
        return study.reference().hides(contender.error().rootMeanSquare());
    }

    /** How many times as long plain work takes. */
    Optional<Double> timesAsLong() {
        return plain.map(time -> time.milliseconds() / figures().milliseconds());
    }

    /** The error, marked where it may be less. */
    String shownError() {
        return (isBound() ? "≤ " : "") + Shown.error(figures().error());
    }

    /** Time at equal error, marked where it may be more or less and where it is not between measured ones. */
    String shownPlain() {
        return (isBound() && plain.isPresent() ? "≥ " : "") + plain.map(time -> switch (time.origin()) {
            case COARSEST -> "≤ " + Shown.duration(time.milliseconds());
            case INTERPOLATED -> Shown.duration(time.milliseconds());
            case EXTRAPOLATED -> Shown.duration(time.milliseconds()) + " *";
        }).orElse("-");
    }

    String shownTimesAsLong() {
        return timesAsLong().map(factor -> (isBound() ? "≥ " : "") + Shown.number(factor)).orElse("-");
    }

    String sentences() {
        if (!study.hasErrors()) {
            return "All settings draw the same picture, to the last bit: there is no error to set beside the time.";
        }
        return (study.family() == Family.SHADOWS ? shadowSentence() : edgeSentence()) + plainSentence();
    }

    private String shadowSentence() {
        return "Exact shadows take " + Shown.duration(figures().milliseconds()) + " for an error " + amount() + ".";
    }

    private String edgeSentence() {
        return EYE_ROOT + " x " + EYE_ROOT + " rays at edges, which are " + shownRefined() + " % of the pixels, take "
            + Shown.duration(figures().milliseconds()) + " for an error " + amount() + ".";
    }

    String shownRefined() {
        return Shown.percent(contender.rendering().refinedShare());
    }

    private String amount() {
        String error = Shown.error(figures().error());
        return isBound() ? "at or below " + error + ", which is the reference's own" : "of " + error;
    }

    private String atLeast() {
        return isBound() ? "at least " : "";
    }

    private String plainSentence() {
        String who = study.family() == Family.SHADOWS ? "sampling " : "rays in every pixel ";
        return plain.map(time -> switch (time.origin()) {
            case COARSEST -> " It takes " + who + Shown.duration(time.milliseconds())
                + " to come below that, with the coarsest setting.";
            case INTERPOLATED -> " It takes " + who + amount(time)
                + " as long (interpolated between measured settings).";
            case EXTRAPOLATED -> " It would take " + who + amount(time)
                + " as long (extrapolated, by the power law that the finer half of the settings follows).";
        }).orElse("");
    }

    private String amount(EqualError.Time time) {
        return atLeast() + Shown.duration(time.milliseconds()) + " to come down to that, "
            + Shown.factor(time.milliseconds() / figures().milliseconds());
    }
}
