package raytracing.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import raytracing.ambient.AmbientLight;
import raytracing.film.Film;
import raytracing.render.RenderSettings;
import raytracing.render.Region;
import raytracing.render.Renderer;
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
     * The halves have random numbers of their own, so neither agrees with a setting by using the same. Their ambient
     * light is that of the settings: it is not what is judged.
     */
    private static final List<Long> SEEDS_OF_HALVES =
        List.of(RenderSettings.DEFAULT_SEED + 1, RenderSettings.DEFAULT_SEED + 2);

    static FamilyStudy of(Family family, Scene scene, AmbientLight ambientLight, RenderSettings settings, Budget budget,
                          Progress progress) {
        Reference reference = reference(family.halves(budget), scene, ambientLight, settings, budget,
            progress.in(family.title()));
        List<Setting> shown = PictureRow.settings(family, scene.settings().shadowRayRoot());
        List<Setting> all = family.settings(scene, budget);
        List<Rounds.Drawn> drawn = Rounds.of(
            all.stream().map(setting -> Renderers.of(scene, setting.in(settings))).toList(),
            times -> Noise.among(all, times), budget, progress.in(family.title()));
        List<Measurement> measurements = new ArrayList<>();
        for (int i = 0; i < all.size(); i++) {
            Film film = drawn.get(i).rendering().film();
            measurements.add(new Measurement(all.get(i), drawn.get(i).rendering().refinedShare(),
                drawn.get(i).milliseconds(), ErrorFigures.of(film, reference), shown.contains(all.get(i))
                    ? Optional.of(Illustration.of(film, reference, budget.shownEdge())) : Optional.empty()));
        }
        return new FamilyStudy(family, reference, measurements);
    }

    private static Reference reference(List<Setting> halves, Scene scene, AmbientLight ambientLight,
                                       RenderSettings settings, Budget budget, Progress progress) {
        List<Region> blocks = Blocks.of(budget.size(), budget.blocksPerCompared());
        List<List<Film>> films = new ArrayList<>();
        long start = System.nanoTime();
        for (int i = 0; i < halves.size(); i++) {
            progress.say("reference, " + halves.get(i).title());
            RenderSettings ofHalf = halves.get(i).in(settings).withSeed(SEEDS_OF_HALVES.get(i));
            Renderer renderer = Renderers.inAmbientLight(Renderers.of(scene, ofHalf), ambientLight);
            films.add(blocks.stream().map(block -> Renderers.film(Renderers.inRegion(renderer, block))).toList());
        }
        double milliseconds = (System.nanoTime() - start) / NANOSECONDS_IN_MILLISECOND / halves.size();
        double blockShare = (double) blocks.size() * blocks.get(0).pixelCount() / settings.region().pixelCount();
        return Reference.of(blocks, films.get(0), films.get(1), milliseconds / blockShare);
    }

    /** The measurements whose times look like noise. */
    Set<Measurement> noisy() {
        Set<Integer> places = Noise.among(measurements.stream().map(Measurement::setting).toList(),
            measurements.stream().map(Measurement::milliseconds).toList());
        return places.stream().map(measurements::get).collect(Collectors.toSet());
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

    Optional<Measurement> of(Series series, double number) {
        return of(series).stream().filter(measurement -> measurement.setting().number() == number).findFirst();
    }

    /** When the settings of a series come down to an error; one ray leads to all of them. */
    Optional<EqualError.Time> timeAt(Series series, double error) {
        Stream<TimedError> measured = Stream.of(Series.ONE_RAY, series)
            .flatMap(some -> of(some).stream())
            .filter(measurement -> !reference.hides(measurement.error().rootMeanSquare()))
            .map(this::figures);
        Stream<TimedError> half = series == family.plain() ? Stream.of(reference.half()) : Stream.of();
        return error > 0 ? new EqualError(Stream.concat(measured, half).toList()).at(error) : Optional.empty();
    }

    /** Whether any setting has an error at all: without one there is nothing to plot. */
    boolean hasErrors() {
        return measurements.stream().anyMatch(measurement -> figures(measurement).error() > 0);
    }
}
