package raytracing.report;

import java.util.Optional;

/**
 * What comes of comparing the clever setting of a family with plain work at equal error.
 *
 * @param study of which scene and family
 * @param contender the setting
 * @param plain when plain work has as little error; nothing where that cannot be said
 */
record Verdict(FamilyStudy study, Measurement contender, Optional<EqualError.Time> plain) {
    /** A step: what a user would choose first. */
    private static final int ERROR_LIMIT = 1;

    static Verdict of(FamilyStudy study) {
        int number = study.family() == Family.EDGES ? ERROR_LIMIT : 1;
        Measurement contender = study.of(study.family().clever(), number).orElseThrow();
        return new Verdict(study, contender,
            study.timeAt(study.family().plain(), study.figures(contender).error()));
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
        return (isBound() && plain.isPresent() ? "≥ " : "") + Tables.shown(plain);
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
        return "`--error " + ERROR_LIMIT + "` gives " + shownRefined() + " % of the pixels more than one ray and takes "
            + Shown.duration(figures().milliseconds()) + " for an error " + amount() + ".";
    }

    String shownRefined() {
        return Shown.percent(contender.refinedShare());
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
