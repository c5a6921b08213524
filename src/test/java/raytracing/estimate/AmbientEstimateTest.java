package raytracing.estimate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.SceneText;
import raytracing.Shared;
import raytracing.ambient.AmbientLight;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.math.Vector;
import raytracing.parallel.ForkJoin;
import raytracing.parallel.Preparation;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Renderers;
import raytracing.scene.CameraRays;
import raytracing.scene.Scene;
import raytracing.trace.Queries;
import raytracing.trace.RayQuery;
import raytracing.trace.ShadowMode;

/** The estimate beside the truth: on paper where there is one, by brute force elsewhere. */
class AmbientEstimateTest {
    /** No pixel looks along an edge of a room: there the truth has two values. */
    private static final RenderSettings SMALL = RenderSettings.DEFAULT.withSize(23, 20);

    /** The truth's own error, a channel: 460 pixels with 2 x 196 rays each. */
    private static final int ROOT = 14;
    private static final int ALL_BOUNCES = 1000;
    private static final double MOST_ERROR_OF_MEAN = 0.03;

    /** A truth of a scene, made once: the white one for means, the coloured one for pictures. */
    private static final Map<String, AmbientPart> TRUTHS = new TreeMap<>();

    private static AmbientPart truth(String name, Scene scene, int seed) {
        return TRUTHS.computeIfAbsent(name + seed,
            key -> AmbientPart.byBruteForce(scene, SMALL.withSeed(seed), ALL_BOUNCES, ROOT));
    }

    static Stream<String> scenes() {
        return Stream.of("open", "half closed", "closed", "Room1");
    }

    private static Scene scene(String name) throws Exception {
        return switch (name) {
            case "open" -> AmbientScenes.open();
            case "half closed" -> AmbientScenes.halfClosed();
            case "closed" -> AmbientScenes.closed();
            default -> {
                Shared.require(Shared.SCENES);
                yield AmbientScenes.room1().orElseThrow();
            }
        };
    }

    /** Every path brings the same series, so there is no error but rounding; up to the largest reflectance that counts. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.1, 0.5, 0.8, 0.9})
    void aWhiteFurnaceHasTheSumOfTheGeometricSeries(double a) {
        Color mean = Renderers.of(AmbientScenes.furnace(a), SMALL).ambientLight().mean();
        assertEquals(a == 0 ? 0 : a / (1 - a), mean.red(), 1e-11);
        assertEquals(mean.red(), mean.green());
        assertEquals(mean.red(), mean.blue());
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.5, 0.9})
    void aWhiteFurnaceIsEvenlyLit(double a) {
        Renderer renderer = Renderers.of(AmbientScenes.furnace(a), SMALL);
        for (double light : AmbientPart.drawn(renderer, renderer.ambientLight()).light()) {
            assertEquals(a * a / (1 - a), light, 1e-11);
        }
    }

    /** The first bounce brings the wall's own 1.5; what goes on is counted as 0.9 of what arrives: 1.5 / (1 - 0.9). */
    @Test
    void wallsThatReflectMoreThanTheyGetDoNotShineForever() {
        assertEquals(15, Renderers.of(AmbientScenes.furnace(1.5), SMALL).ambientLight().mean().red(), 1e-11);
    }

    /** Nothing is in the way of the sky: all rays bring the background. */
    @Test
    void aBallAloneInTheSkyHasTheSkysLight() {
        Scene scene = SceneText.scene("cam 0 0 -5  0 0 0  0 1 0  1 1", "set 0.25 0.5 0.75  1 5",
            "mtl 0.5 0.5 0.5  0 0 0  0 0 0  1 0  1 1 1", "sph 0 0 0 1 1");
        Color mean = Renderers.of(scene, SMALL).ambientLight().mean();
        assertEquals(0.25, mean.red(), 1e-14);
        assertEquals(0.5, mean.green(), 1e-14);
        assertEquals(0.75, mean.blue(), 1e-14);
    }

    /** As far as the one colour goes, an estimate for white ambient colours is the ambient light itself. */
    @ParameterizedTest
    @MethodSource("scenes")
    void theOneColourIsTheMeanOfTheTruth(String name) throws Exception {
        Scene white = AmbientScenes.withWhiteAmbient(scene(name));
        double[] truth = truth("white " + name, white, 1).mean();
        Renderer renderer = Renderers.of(white, SMALL);
        double[] mean = AmbientPart.drawn(renderer, AmbientLight.even(renderer.ambientLight().mean())).mean();
        for (int channel = 0; channel < truth.length; channel++) {
            assertEquals(1, mean[channel] / truth[channel], MOST_ERROR_OF_MEAN, "channel " + channel);
        }
    }

    /** Of the error of no ambient light, one colour leaves at most a third, and light that varies at most a tenth. */
    @ParameterizedTest
    @MethodSource("scenes")
    void lightThatVariesIsNearerToTheTruthThanOneColourAndThatThanNone(String name) throws Exception {
        Scene scene = scene(name);
        Renderer renderer = Renderers.of(scene, SMALL);
        AmbientLight estimate = renderer.ambientLight();
        double none = error(name, scene, renderer, AmbientLight.even(Color.BLACK));
        double even = error(name, scene, renderer, AmbientLight.even(estimate.mean()));
        double varying = error(name, scene, renderer, estimate);
        assertTrue(even < none / 3, none + ", " + even);
        assertTrue(varying < even / 2, even + ", " + varying);
        assertTrue(varying < none / 10, none + ", " + varying);
    }

    /** The room of triangles against the truth of the room of planes, within the bounds above. */
    @Test
    void aRoomOfTrianglesHasTheAmbientLightOfARoomOfPlanes() {
        Scene white = AmbientScenes.withWhiteAmbient(AmbientScenes.closedOfTriangles());
        double[] truth = truth("white closed", AmbientScenes.withWhiteAmbient(AmbientScenes.closed()), 1).mean();
        Renderer whiteRenderer = Renderers.of(white, SMALL);
        double[] mean = AmbientPart.drawn(whiteRenderer, AmbientLight.even(whiteRenderer.ambientLight().mean())).mean();
        for (int channel = 0; channel < truth.length; channel++) {
            assertEquals(1, mean[channel] / truth[channel], MOST_ERROR_OF_MEAN, "channel " + channel);
        }
        Renderer renderer = Renderers.of(AmbientScenes.closedOfTriangles(), SMALL);
        double none = error("closed", AmbientScenes.closed(), renderer, AmbientLight.even(Color.BLACK));
        double varying = error("closed", AmbientScenes.closed(), renderer, renderer.ambientLight());
        assertTrue(varying < none / 10, none + ", " + varying);
    }

    private static double error(String name, Scene scene, Renderer renderer, AmbientLight light) {
        return AmbientPart.drawn(renderer, light).errorAgainst(truth(name, scene, 1), truth(name, scene, 2));
    }

    /** The answer is known for every point of the floor, from 0 where the ball touches it to nearly 1. */
    @Test
    void theFloorUnderABallIsAsDarkAsOnPaper() {
        assertEquals(0, pictureError(underBall(Double.POSITIVE_INFINITY, 1, 1)), 3);
    }

    /** From 1.9 to 1.1 steps with these seeds. */
    @Test
    void refinementLowersTheError() {
        double usual = 0;
        double refined = 0;
        for (int seed = 1; seed <= 3; seed++) {
            usual += square(pictureError(underBall(Double.POSITIVE_INFINITY, seed, 1)));
            refined += square(pictureError(underBall(0.25, seed, 1)));
        }
        assertTrue(refined < usual / 2, refined + ", " + usual);
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.POSITIVE_INFINITY, 0.25})
    void whatTheEstimateSaysOfItsErrorIsTrueWithinAFactorOf2(double mostError) {
        double estimated = 0;
        double error = 0;
        for (int seed = 1; seed <= 3; seed++) {
            AmbientLight light = underBall(mostError, seed, 1);
            estimated += square(light.error());
            error += square(pictureError(light));
        }
        assertTrue(estimated > error / 4 && estimated < 4 * error, estimated + " for " + error);
    }

    private static double square(double x) {
        return x * x;
    }

    @Test
    void anErrorThatIsThereAlreadyAsksForNoMorePaths() {
        AmbientLight light = underBall(64, 1, 1);
        assertEquals(light.recordCount() * DiffusePaths.PATHS, light.pathCount());
        assertTrue(underBall(0.25, 1, 1).pathCount() > 10 * light.pathCount());
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 8})
    void refinedLightIsTheSameForEveryNumberOfThreads(int threads) {
        AmbientLight one = underBall(0.5, 1, 1);
        AmbientLight other = underBall(0.5, 1, threads);
        assertEquals(one.mean(), other.mean());
        assertEquals(one.error(), other.error());
        assertEquals(one.pathCount(), other.pathCount());
    }

    private static final Scene UNDER_BALL = AmbientScenes.blackBallOverFloor(1, 1);
    private static final RenderSettings LARGER = RenderSettings.DEFAULT.withSize(60, 60);

    private static AmbientLight underBall(double mostError, long seed, int threads) {
        return AmbientEstimate.of(UNDER_BALL, Queries.prepared(UNDER_BALL, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT), 60, 60,
            seed, mostError, new ForkJoin(threads, new Preparation()));
    }

    /** Root mean square of the picture, in steps: the ball and the sky have no ambient colour, and so no error. */
    private static double pictureError(AmbientLight light) {
        Film film = Renderers.film(Renderers.inAmbientLight(Renderers.of(UNDER_BALL, LARGER), light));
        double squares = 0;
        int pixel = 0;
        for (Optional<Vector> point : floorPoints()) {
            if (point.isPresent()) {
                double aside = Math.hypot(point.get().x(), point.get().z());
                squares += square(film.get(pixel % 60, pixel / 60).red() - AmbientScenes.lightUnderBlackBall(1, 1, aside));
            }
            pixel++;
        }
        return 255 * Math.sqrt(squares / pixel);
    }

    /** What each pixel of the larger picture shows of the floor. */
    private static List<Optional<Vector>> floorPoints() {
        CameraRays rays = new CameraRays(UNDER_BALL.camera(), 60, 60);
        RayQuery query = new RayQuery(Queries.prepared(UNDER_BALL, ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT));
        List<Optional<Vector>> points = new ArrayList<>();
        for (int pixel = 0; pixel < 60 * 60; pixel++) {
            rays.start(pixel % 60 + 0.5, pixel / 60 + 0.5, query.ray());
            query.begin();
            points.add(query.advance() && query.surface() == 0
                ? Optional.of(new Vector(query.hit().x(), query.hit().y(), query.hit().z())) : Optional.empty());
        }
        return points;
    }

    @Test
    void aSceneWithoutAmbientColoursIsNotLookedAt() {
        Scene scene = SceneText.scene("cam 0 0 -5  0 0 0  0 1 0  1 1", "set 1 1 1  1 5",
            "mtl 0.5 0.5 0.5  0 0 0  0 0 0  1 0", "mtl 0.5 0.5 0.5  0 0 0  0 0 0  1 0  1 1 1", "sph 0 0 0 1 1");
        assertTrue(Renderers.of(scene, SMALL).ambientLight().isNone());
    }

    @Test
    void aScaleOf0TurnsAmbientLightOff() {
        Scene scene = SceneText.scene("cam 0 0 -5  0 0 0  0 1 0  1 1", "set 1 1 1  1 5  0",
            "mtl 0.5 0.5 0.5  0 0 0  0 0 0  1 0  1 1 1", "sph 0 0 0 1 1");
        Renderer renderer = Renderers.of(scene, SMALL);
        assertTrue(renderer.ambientLight().isNone());
        assertEquals(Color.BLACK, Renderers.pixel(renderer, 11, 10));
    }

    /** A ball that covers a 6000th of the picture, and so one of the first 24 x 24 places only for a seed in ten. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6})
    void theOnlyThingWithAnAmbientColourIsFoundIfItIsSmall(int seed) {
        Scene scene = SceneText.scene("cam 0 0 -5  0 0 0  0 1 0  1 1", "set 1 1 1  1 5",
            "mtl 0 0 0  0 0 0  0 0 0  1 0  1 1 1", "sph 1.1 0.7 0  0.036 1");
        assertEquals(1, Renderers.of(scene, SMALL.withSeed(seed)).ambientLight().mean().red(), 1e-14);
    }

    @Test
    void whatIsNotSeenNeedsNoAmbientLight() {
        Scene scene = SceneText.scene("cam 0 0 -5  0 0 0  0 1 0  1 1", "set 1 1 1  1 5",
            "mtl 0 0 0  0 0 0  0 0 0  1 0  1 1 1", "sph 0 0 -50  1 1");
        assertTrue(Renderers.of(scene, SMALL).ambientLight().isNone());
    }

    @Test
    void whatIsSeenInAMirrorAloneCountsToo() {
        Scene scene = SceneText.scene("cam 0 0 -5  0 0 0  0 1 0  1 1", "set 0.5 0.5 0.5  1 5",
            "mtl 0 0 0  0 0 0  1 1 1  1 0", "mtl 0 0 0  0 0 0  0 0 0  1 0  1 1 1", "pln 0 0 1 0 1", "sph 0 0 -12 3 2");
        assertTrue(Renderers.of(scene, SMALL).ambientLight().mean().red() > 0.3);
    }

    /**
     * Far out on an endless floor nothing is in the way of the sky, and few places lie there: it has the sky's light all
     * the same.
     */
    @Test
    void anEndlessFloorIsEvenUpToItsHorizon() {
        Scene scene = AmbientScenes.blackBallOverFloor(1, 0.2);
        RenderSettings settings = RenderSettings.DEFAULT.withSize(40, 400);
        Film film = Renderers.film(scene, settings);
        for (int y = 0; y < 190; y++) {
            assertEquals(1, film.get(1, y).red(), 0.01, "row " + y);
        }
    }

    /** However large colours and lengths are: light is a number. */
    @Test
    void coloursAtTheEndOfTheRangeGiveFiniteLight() {
        Scene scene = SceneText.scene("cam 0 0 -5  0 0 0  0 1 0  1 1", "set 1e-310 1e300 1  1 5",
            "mtl 1e300 1e-310 1  1e300 0 0  0 1 1e300  1 0.5  1e300 1e-310 1",
            "mtl 1e300 0 1e-310  0 0 0  0 0 0  1 0  1 1e300 0",
            "sph 0 0 0 1 1", "pln 0 1 0 -2 2", "pln 1 0 0 -3 1", "lgt 3 3 -3 1e300 1 1e-310  1 1 0");
        Film film = Renderers.film(scene, SMALL);
        for (int pixel = 0; pixel < 23 * 20; pixel++) {
            Color color = film.get(pixel % 23, pixel / 23);
            assertTrue(color.red() >= 0 && color.green() >= 0 && color.blue() >= 0, color::toString);
        }
    }
}
