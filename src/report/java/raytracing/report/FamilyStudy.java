package raytracing.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import raytracing.ambient.AmbientLight;
import raytracing.film.Film;
import raytracing.render.RenderSettings;
import raytracing.render.Renderers;
import raytracing.scene.Scene;

/**
 * One question asked of one scene.
 *
 * @param family the question
 * @param reference what the answers are held to
 * @param measurements the answers, in the order of the settings
 */
record FamilyStudy(Family family, Reference reference, List<Measurement> measurements) {
    private static final double NANOSECONDS_IN_MILLISECOND = 1e6;

    /**
     * The halves have random numbers of their own, so neither agrees with a setting by using the same. Their ambient light is that
     * of the settings: it is not what is judged.
     */
    private static final List<Long> SEEDS_OF_HALVES =
        List.of(RenderSettings.DEFAULT_SEED + 1, RenderSettings.DEFAULT_SEED + 2);

    static FamilyStudy of(Family family, Scene scene, AmbientLight ambientLight, RenderSettings settings, Budget budget,
                          Progress progress) {
        Reference reference = reference(family.halves(budget), scene, ambientLight, settings,
            progress.in(family.title()));
        List<Setting> all = family.settings(scene, budget);
        List<Rounds.Drawn> drawn = Rounds.of(
            all.stream().map(setting -> Renderers.of(scene, setting.in(settings))).toList(), budget,
            progress.in(family.title()));
        List<Measurement> measurements = new ArrayList<>();
        for (int i = 0; i < all.size(); i++) {
            measurements.add(new Measurement(all.get(i), drawn.get(i).rendering(), drawn.get(i).milliseconds(),
                ErrorFigures.of(drawn.get(i).rendering().film(), reference.film())));
        }
        return new FamilyStudy(family, reference, measurements);
    }

    private static Reference reference(List<Setting> halves, Scene scene, AmbientLight ambientLight,
                                       RenderSettings settings, Progress progress) {
        List<Film> films = new ArrayList<>();
        long start = System.nanoTime();
        for (int i = 0; i < halves.size(); i++) {
            progress.say("reference, " + halves.get(i).title());
            RenderSettings ofHalf = halves.get(i).in(settings).withSeed(SEEDS_OF_HALVES.get(i));
            films.add(Renderers.film(Renderers.inAmbientLight(Renderers.of(scene, ofHalf), ambientLight)));
        }
        double milliseconds = (System.nanoTime() - start) / NANOSECONDS_IN_MILLISECOND;
        return Reference.of(films.get(0), films.get(1), milliseconds / halves.size());
    }

    /** What is known of a measurement's time and error: no error is known to be below the reference's own. */
    TimedError figures(Measurement measurement) {
        return new TimedError(measurement.milliseconds().median(),
            reference.error(measurement.error().rootMeanSquare()));
    }

    List<Measurement> front() {
        return ParetoFront.of(measurements, this::figures);
    }

    List<Measurement> of(Series series) {
        return measurements.stream().filter(measurement -> measurement.setting().series() == series).toList();
    }

    Optional<Measurement> of(Series series, int number) {
        return of(series).stream().filter(measurement -> measurement.setting().number() == number).findFirst();
    }

    /** The settings that get better by more work alone: one ray, all of their series, and a half of the reference. */
    List<TimedError> plainSeries() {
        Stream<TimedError> measured = Stream.of(Series.ONE_RAY, family.plain())
            .flatMap(series -> of(series).stream())
            .filter(measurement -> !reference.hides(measurement.error().rootMeanSquare()))
            .map(this::figures);
        return Stream.concat(measured, Stream.of(reference.half())).toList();
    }

    /** When those come down to the error of a measurement. */
    Optional<EqualError.Time> plainTimeAtErrorOf(Measurement measurement) {
        double error = figures(measurement).error();
        return error > 0 ? new EqualError(plainSeries()).at(error) : Optional.empty();
    }

    /** Whether any setting has an error at all: without one there is nothing to plot. */
    boolean hasErrors() {
        return measurements.stream().anyMatch(measurement -> figures(measurement).error() > 0);
    }
}
