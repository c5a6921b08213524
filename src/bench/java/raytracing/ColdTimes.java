package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.stream.IntStream;
import raytracing.parse.RayTracerException;
import raytracing.timed.ProcessCost;
import raytracing.timed.Spread;
import raytracing.timed.ToPovRay;

/** Whole processes from their start to their end, ours and POV-Ray's in turn. */
final class ColdTimes {
    static final List<TimedScene> SCENES = List.of(
        TimedScene.ROOM1, TimedScene.SPHERES, TimedScene.POOL, TimedScene.NEST,
        TimedScene.FLAKE_820, TimedScene.FLAKE_7381, TimedScene.FLAKE_7381_SOFT, TimedScene.FLAKE_66430,
        TimedScene.FLAKE_597871, TimedScene.FLAKE_597871_SOFT,
        TimedScene.KNOT_100000, TimedScene.KNOT_100000_SOFT,
        TimedScene.ROOM, TimedScene.BUBBLES, TimedScene.BOXES);

    /** How many times as long as ours POV-Ray should take at least. */
    private static final Map<TimedScene, Integer> ASKED = Map.of(
        TimedScene.ROOM1, 3, TimedScene.SPHERES, 4, TimedScene.POOL, 6, TimedScene.NEST, 8,
        TimedScene.FLAKE_597871, 3, TimedScene.FLAKE_597871_SOFT, 5,
        TimedScene.KNOT_100000, 1, TimedScene.KNOT_100000_SOFT, 4);

    private static final String NONE = "-";

    private final List<Match> matches = new ArrayList<>();

    private ColdTimes() {
    }

    /** Runs in the order in which they were made; the peer has none if it is not installed. */
    private record Match(TimedScene scene, List<ProcessCost> ours, List<ProcessCost> peers) {
        List<String> cells() {
            return List.of(scene.title(),
                shown(walls(ours), 2), shown(walls(peers), 2), ratioOfMedians(), ratioOfPairs(), asked(),
                shown(processors(ours), 2), shown(processors(peers), 2),
                shown(memories(ours), 0), shown(memories(peers), 0));
        }

        private String ratioOfMedians() {
            Optional<Spread> peer = Spread.of(walls(peers));
            double our = Spread.of(walls(ours)).orElseThrow().median();
            return peer.map(spread -> String.format(Locale.ROOT, "%.2f", spread.median() / our)).orElse(NONE);
        }

        private String ratioOfPairs() {
            return shown(IntStream.range(0, peers.size())
                .mapToObj(i -> peers.get(i).wallSeconds() / ours.get(i).wallSeconds()).toList(), 2);
        }

        private String asked() {
            return Optional.ofNullable(ASKED.get(scene)).map(String::valueOf).orElse(NONE);
        }
    }

    /**
     * Measures.
     *
     * @param folder where scenes and pictures may be left
     */
    static ColdTimes measured(List<TimedScene> scenes, Effort effort, Optional<PovRay> povRay, Path folder)
            throws IOException, RayTracerException {
        ColdTimes times = new ColdTimes();
        for (TimedScene scene : scenes) {
            times.matches.add(match(scene, effort, povRay, folder));
        }
        return times;
    }

    private static Match match(TimedScene scene, Effort effort, Optional<PovRay> povRay, Path folder)
            throws IOException, RayTracerException {
        Match match = new Match(scene, new ArrayList<>(), new ArrayList<>());
        List<String> ours = MeasuredProcess.program(scene.file(folder).toString(),
            folder.resolve("ours.png").toString());
        Path translated = folder.resolve("peer.pov");
        if (povRay.isPresent()) {
            Files.writeString(translated, ToPovRay.of(scene.scene()));
        }
        for (int pair = 0; pair < effort.pairs(); pair++) {
            match.ours.add(MeasuredProcess.run(ours));
            if (povRay.isPresent()) {
                match.peers.add(MeasuredProcess.run(povRay.get().command(translated, folder.resolve("peer.png"))));
            }
            System.out.println("Pair " + (pair + 1) + " of " + scene.title() + ", s: ours " + walls(match.ours)
                + ", POV-Ray " + walls(match.peers));
        }
        return match;
    }

    private static List<Double> walls(List<ProcessCost> costs) {
        return costs.stream().map(ProcessCost::wallSeconds).toList();
    }

    private static List<Double> processors(List<ProcessCost> costs) {
        return known(costs, ProcessCost::cpuSeconds);
    }

    private static List<Double> memories(List<ProcessCost> costs) {
        return known(costs, ProcessCost::peakMebibytes);
    }

    private static List<Double> known(List<ProcessCost> costs, Function<ProcessCost, OptionalDouble> figure) {
        return costs.stream().map(figure).flatMapToDouble(OptionalDouble::stream).boxed().toList();
    }

    private static String shown(List<Double> values, int decimals) {
        return Spread.of(values).map(spread -> spread.shown(decimals)).orElse(NONE);
    }

    /** Median of POV-Ray's processor time for a scene, in seconds, if it was measured. */
    Optional<Double> peersProcessorSeconds(TimedScene scene) {
        return matches.stream().filter(match -> match.scene == scene).findFirst()
            .flatMap(match -> Spread.of(processors(match.peers))).map(Spread::median);
    }

    String table() {
        return MarkdownTable.of(List.of("scene", "ours, s", "POV-Ray, s", "ratio of medians", "ratios of the pairs",
            "asked: at least", "ours, CPU s", "POV-Ray, CPU s", "ours, MiB", "POV-Ray, MiB"),
            matches.stream().map(Match::cells).toList());
    }
}
