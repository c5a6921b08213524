package raytracing.report;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import raytracing.PovRay;
import raytracing.render.RenderSettings;
import raytracing.render.Renderers;
import raytracing.scene.Scene;

/** What both programs are asked to draw, each in all its ways; each is held to its own converged picture. */
enum PeerQuestion {
    /** One ray a pixel: how near is the light of the wide lamps? */
    SHADOWS("Soft shadows, one ray a pixel") {
        @Override
        Map<Method, List<Contender>> theirs(Peer peer) {
            Map<Method, List<Contender>> methods = new LinkedHashMap<>();
            methods.put(new Method("POV-Ray: k x k points", PEER_PLAIN),
                POINTS.stream().map(k -> peer.shadows(k, "jitter")).toList());
            methods.put(new Method("POV-Ray: k x k points, adaptive 0", PEER_ADAPTIVE),
                FINER_POINTS.stream().map(k -> peer.shadows(k, "jitter adaptive 0")).toList());
            methods.put(new Method("POV-Ray: k x k points, adaptive 1", PEER_MORE_ADAPTIVE),
                FINER_POINTS.stream().map(k -> peer.shadows(k, "jitter adaptive 1")).toList());
            return methods;
        }

        @Override
        List<Contender> halvesOfTheirs(Peer peer) {
            return List.of(peer.shadows(CONVERGED, "jitter adaptive 4"),
                peer.shadows(2 * CONVERGED - 1, "jitter adaptive 4"));
        }

        @Override
        Map<Method, List<Setting>> ours() {
            Map<Method, List<Setting>> methods = new LinkedHashMap<>();
            methods.put(new Method("ours: N x N shadow rays", OUR_PLAIN), POINTS.stream().map(Setting::sampled).toList());
            methods.put(new Method("ours: --shadows exact", OUR_CLEVER), List.of(Setting.exact()));
            return methods;
        }

        @Override
        List<Setting> halvesOfOurs() {
            return Family.SHADOWS.halves(Budget.OF_ONE);
        }
    },

    /** How near is the mean light of the whole pixel, soft shadows and edges? */
    PIXELS("Soft shadows and smooth edges") {
        @Override
        Map<Method, List<Contender>> theirs(Peer peer) {
            Map<Method, List<Contender>> methods = new LinkedHashMap<>();
            methods.put(new Method("POV-Ray: +AM1", PEER_PLAIN), peer.antiAliased("+AM1", DEPTHS_OF_GRIDS));
            methods.put(new Method("POV-Ray: +AM2", PEER_ADAPTIVE), peer.antiAliased("+AM2", DEPTHS_OF_DIVISIONS));
            return methods;
        }

        @Override
        List<Contender> halvesOfTheirs(Peer peer) {
            return List.of(peer.many(CONVERGED_RAYS), peer.many(CONVERGED_RAYS - 1));
        }

        @Override
        Map<Method, List<Setting>> ours() {
            Map<Method, List<Setting>> methods = new LinkedHashMap<>();
            methods.put(new Method("ours: --shadows exact --samples n", OUR_PLAIN),
                List.of(2, 3, 4, 6, 8).stream().map(Setting::atEdges).toList());
            methods.put(new Method("ours: --error E", OUR_CLEVER),
                Budget.OF_ONE.errorLimits().stream().map(Setting::errorLimit).toList());
            return methods;
        }

        @Override
        List<Setting> halvesOfOurs() {
            return Family.EDGES.halves(Budget.OF_ONE);
        }
    };

    private static final List<Integer> POINTS = List.of(2, 3, 5, 9, 17);
    private static final List<Integer> FINER_POINTS = List.of(3, 5, 9, 17, 33);

    /** POV-Ray puts the outer points on the lamp's edge, so its lamps come to their size only with many. */
    private static final int CONVERGED = 129;

    /** n of n x n rays in every pixel of a converged picture. */
    private static final int CONVERGED_RAYS = 8;

    /** +R of the two methods of anti-aliasing, each with a finer threshold than the one before. */
    private static final List<Integer> DEPTHS_OF_GRIDS = List.of(2, 3, 4, 6, 8);
    private static final List<Integer> DEPTHS_OF_DIVISIONS = List.of(1, 2, 3, 4);

    private static final Curve.Look PEER_PLAIN = new Curve.Look(Ink.VERMILION, Series.Shape.CIRCLE);
    private static final Curve.Look PEER_ADAPTIVE = new Curve.Look(Ink.PURPLE, Series.Shape.SQUARE);
    private static final Curve.Look PEER_MORE_ADAPTIVE = new Curve.Look(Ink.TEXT, Series.Shape.DIAMOND);
    private static final Curve.Look OUR_PLAIN = new Curve.Look(Ink.BLUE, Series.Shape.CIRCLE);
    private static final Curve.Look OUR_CLEVER = new Curve.Look(Ink.GREEN, Series.Shape.TRIANGLE);

    private final String title;

    PeerQuestion(String title) {
        this.title = title;
    }

    String title() {
        return title;
    }

    /** A curve that is still to be measured. */
    record Method(String title, Curve.Look look) {
    }

    /**
     * What POV-Ray draws, and where its files may lie.
     *
     * @param povRay that is installed
     * @param scene in our words
     * @param folder for its files
     * @param size of the pictures, in pixels
     */
    record Peer(PovRay povRay, Scene scene, Path folder, int size) {
        /** Points of a wide light where many rays meet in a pixel. */
        private static final int FINE_POINTS = 17;

        private static final int FINEST_POINTS = 65;

        /** With one ray a pixel. */
        Contender shadows(int points, String method) {
            return new PovRayContender(povRay, points + " x " + points, scene, folder.resolve("peer"), size, 1, points,
                method, List.of("-A"));
        }

        /** With its own anti-aliasing: the deeper, the smaller are the differences that it looks into. */
        List<Contender> antiAliased(String method, List<Integer> depths) {
            List<Contender> contenders = new ArrayList<>();
            for (int i = 0; i < depths.size(); i++) {
                String threshold = "+A" + THRESHOLDS.get(i);
                contenders.add(new PovRayContender(povRay, threshold + " +R" + depths.get(i), scene,
                    folder.resolve("peer"), size, 1, FINE_POINTS, "jitter adaptive 1",
                    List.of(method, threshold, "+R" + depths.get(i))));
            }
            return contenders;
        }

        /** With n x n rays in every pixel. */
        Contender many(int rays) {
            return new PovRayContender(povRay, rays + " x " + rays + " rays", scene, folder.resolve("peer"), size, rays,
                FINEST_POINTS, "jitter adaptive 2", List.of("-A"));
        }

        private static final List<String> THRESHOLDS = List.of("0.3", "0.1", "0.03", "0.01", "0.003");
    }

    /** POV-Ray's curves, their settings from coarse to fine. */
    abstract Map<Method, List<Contender>> theirs(Peer peer);

    /** The pictures whose mean is POV-Ray's converged one. */
    abstract List<Contender> halvesOfTheirs(Peer peer);

    /** Our curves, their settings from coarse to fine. */
    abstract Map<Method, List<Setting>> ours();

    /** The pictures whose mean is our converged one. */
    abstract List<Setting> halvesOfOurs();

    /** Our settings as contenders. */
    static List<Contender> contenders(List<Setting> settings, Scene scene, RenderSettings common) {
        return settings.stream().<Contender>map(setting ->
            new OurContender(setting.title(), Renderers.of(scene, setting.in(common)))).toList();
    }
}
