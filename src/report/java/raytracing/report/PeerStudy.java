package raytracing.report;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import raytracing.Films;
import raytracing.Quantiles;
import raytracing.film.Film;
import raytracing.render.RenderSettings;
import raytracing.render.Renderers;
import raytracing.scene.Scene;

/**
 * Both programs' answers to a question.
 *
 * @param question that was asked
 * @param theirs POV-Ray's curves
 * @param ours our curves
 * @param errorOfTheirs what is left in POV-Ray's converged picture
 * @param errorOfOurs what is left in our converged picture
 */
record PeerStudy(PeerQuestion question, List<Curve> theirs, List<Curve> ours, double errorOfTheirs, double errorOfOurs) {
    /** Steps of 1/255 at which the two are compared. */
    private static final List<Double> STEPS = List.of(4.0, 2.0, 1.0, 0.5, 0.25);

    private static final double STEP = 1.0 / 255;
    private static final String NONE = "-";

    /** Draws everything in turn, round after round. */
    static PeerStudy of(PeerQuestion question, PeerQuestion.Peer peer, RenderSettings common, int rounds,
                        Progress progress) throws IOException {
        progress.say("POV-Ray's converged picture");
        Reference theirs = reference(films(question.halvesOfTheirs(peer)));
        progress.say("our converged picture");
        Reference ours = reference(halves(question.halvesOfOurs(), peer.scene(), common));
        Map<PeerQuestion.Method, List<Contender>> theirMethods = question.theirs(peer);
        Map<PeerQuestion.Method, List<Contender>> ourMethods = new LinkedHashMap<>();
        question.ours().forEach((method, settings) ->
            ourMethods.put(method, PeerQuestion.contenders(settings, peer.scene(), common)));
        Map<Contender, List<Double>> times = new LinkedHashMap<>();
        Map<Contender, Film> films = new LinkedHashMap<>();
        List<Contender> all = Stream.of(theirMethods, ourMethods).flatMap(methods -> methods.values().stream())
            .flatMap(List::stream).toList();
        for (int round = 0; round < rounds; round++) {
            for (Contender contender : all) {
                progress.say("round " + (round + 1) + " of " + rounds + ", " + contender.title());
                Contender.Drawn drawn = contender.draw();
                times.computeIfAbsent(contender, none -> new ArrayList<>()).add(drawn.milliseconds());
                films.putIfAbsent(contender, drawn.film());
            }
        }
        return new PeerStudy(question, curves(theirMethods, theirs, times, films), curves(ourMethods, ours, times, films),
            theirs.ownError(), ours.ownError());
    }

    private static List<Film> films(List<Contender> contenders) throws IOException {
        List<Film> films = new ArrayList<>();
        for (Contender contender : contenders) {
            films.add(contender.draw().film());
        }
        return films;
    }

    private static List<Film> halves(List<Setting> settings, Scene scene, RenderSettings common) {
        List<Film> films = new ArrayList<>();
        for (Setting setting : settings) {
            films.add(Renderers.film(scene, setting.in(common).withSeed(common.seed() + 1 + films.size())));
        }
        return films;
    }

    private static Reference reference(List<Film> halves) {
        return Reference.of(halves.get(0), halves.get(1), 1);
    }

    private static List<Curve> curves(Map<PeerQuestion.Method, List<Contender>> methods, Reference reference,
                                      Map<Contender, List<Double>> times, Map<Contender, Film> films) {
        Film aim = reference.whole().orElseThrow();
        return methods.entrySet().stream().map(entry -> new Curve(entry.getKey().title(), entry.getKey().look(),
            entry.getValue().stream().map(contender -> {
                double distance = Films.rootMeanSquare(films.get(contender), aim);
                return new Curve.Point(contender.title(), Quantiles.of(times.get(contender)), reference.error(distance),
                    reference.hides(distance));
            }).toList())).toList();
    }

    /** All settings of both. */
    Table settings() {
        return new Table(question.title() + ", all settings: processor time of a frame, median (quartiles), and RMSE in "
            + "linear light against the program's own converged picture, whose own error is "
            + Shown.error(errorOfTheirs) + " for POV-Ray and " + Shown.error(errorOfOurs) + " for ours.",
            List.of("method", "setting", "CPU, ms", "error", "in steps"),
            Stream.concat(theirs.stream(), ours.stream()).flatMap(curve -> curve.points().stream().map(point -> List.of(
                curve.title(), point.title(), Shown.quartiles(point.milliseconds()),
                (point.isBound() ? "≤ " : "") + Shown.error(point.error()),
                (point.isBound() ? "≤ " : "") + Shown.steps(point.error())))).toList());
    }

    /** Who needs how much for the same error. */
    Table equalError() {
        return new Table(question.title() + ", at equal error: processor time of a frame by each program's best method. "
            + "* extrapolated; ≤ the coarsest setting is right to that already.",
            List.of("RMSE, steps", "POV-Ray", "by", "ours", "by", "POV-Ray over ours"),
            STEPS.stream().map(this::cells).toList());
    }

    private List<String> cells(double steps) {
        Optional<Best> their = best(theirs, steps * STEP);
        Optional<Best> our = best(ours, steps * STEP);
        return List.of(Shown.plain(steps), their.map(best -> best.time().shown()).orElse(NONE),
            their.map(Best::method).orElse(NONE), our.map(best -> best.time().shown()).orElse(NONE),
            our.map(Best::method).orElse(NONE), their.flatMap(best -> our.map(other ->
                Shown.rough(best.time().milliseconds() / other.time().milliseconds()))).orElse(NONE));
    }

    /** The method that comes down to an error first. */
    private record Best(String method, EqualError.Time time) {
    }

    private static Optional<Best> best(List<Curve> curves, double error) {
        return curves.stream()
            .flatMap(curve -> curve.at(error).map(time ->
                new Best(curve.title().replaceFirst("^[^:]*: ", ""), time)).stream())
            .min(Comparator.comparingDouble(best -> best.time().milliseconds()));
    }

    /** A sentence on who needs how much for half a step, or for the smallest error that both were measured at. */
    String sentence() {
        return STEPS.stream().filter(steps -> best(theirs, steps * STEP).isPresent() && best(ours, steps * STEP).isPresent())
            .min(Comparator.comparingDouble(steps -> Math.abs(steps * STEP - Recommendation.AIM)))
            .map(steps -> {
                double factor = best(theirs, steps * STEP).orElseThrow().time().milliseconds()
                    / best(ours, steps * STEP).orElseThrow().time().milliseconds();
                return question.title() + ": for an error of " + Shown.plain(steps) + " steps POV-Ray needs "
                    + Shown.rough(factor) + " times the processor time of ours.";
            }).orElse(question.title() + ": no error was reached by both programs.");
    }

    /** The curves of both on the same axes. */
    Svg plot() throws IOException {
        List<TimedError> all = Stream.concat(theirs.stream(), ours.stream())
            .flatMap(curve -> curve.points().stream()).map(Curve.Point::figures).toList();
        ErrorChart chart = new ErrorChart("processor time of a frame, ms",
            LogarithmicRange.around(all.stream().map(TimedError::milliseconds).toList()),
            LogarithmicRange.around(Stream.concat(Stream.of(Recommendation.AIM), all.stream().map(TimedError::error))
                .filter(error -> error > 0).toList()));
        Stream.concat(theirs.stream(), ours.stream()).forEach(curve -> add(chart, curve));
        chart.level("half a step of 1/255", Recommendation.AIM, ErrorChart.DASHED);
        return chart.svg();
    }

    private void add(ErrorChart chart, Curve curve) {
        Ink ink = curve.look().ink();
        curve.points().forEach(point -> chart.whisker(curve.title() + ", " + point.title() + ", quartiles",
            point.milliseconds().lower(), point.milliseconds().upper(), point.error(), ink));
        chart.line(curve.title(), curve.points().stream().map(Curve.Point::figures).toList(), ink, ErrorChart.THIN,
            ErrorChart.marker(curve.look().shape()));
        Curve.Point last = curve.points().get(curve.points().size() - 1);
        boolean isAbove = theirs.indexOf(curve) % 2 == 0;      // of neighbouring curves one has its label above, one below
        chart.label(last.title() + (last.isBound() ? ", or less" : ""), last.figures(), isAbove ? 1 : -1);
    }
}
