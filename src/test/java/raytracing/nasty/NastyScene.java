package raytracing.nasty;

import java.nio.charset.StandardCharsets;
import java.util.SplittableRandom;
import raytracing.parallel.ForkJoin;
import raytracing.parse.RayTracerException;
import raytracing.parse.SceneParser;
import raytracing.render.PixelGrid;
import raytracing.render.RenderSettings;
import raytracing.scene.Scene;
import raytracing.shadow.ShadowMethod;
import raytracing.trace.ShadowMode;

/**
 * A scene that the format allows and that no person would write: sizes from the least double to 1e300, many at once;
 * surfaces that coincide, touch, or lie in each other; eye and lamps on surfaces and in one place; mirrors that brighten;
 * colours, exponents and lamps of any size.
 *
 * <p>What a picture may cost is limited to about five seconds, for an N of 1024, a thousand reflections and sixty surfaces
 * at once are 10^11 tests of a surface for a pixel. So N is at most such that the shadow rays that
 * a picture could need, times the surfaces, stay within 6 10^8 where lengths are ordinary (1024 with one lamp and two
 * surfaces) and 2 10^7 elsewhere. A hall whose surfaces are transparent mirrors, where the rays of every pixel may meet the
 * 4096 surfaces that the program allows them, is drawn with one ray for each pixel and has few surfaces and lamps: 11
 * without a lamp, 5 with one. Glass is less dear: 38 surfaces without a lamp, 27 with one. Exact shadows cut a light into
 * as many pieces as the outlines before it make of a square, which grows with the square of their number: up to
 * {@value #MOST_FOR_EXACT_SHADOWS} surfaces.
 *
 * @param seed which scene
 * @param text the scene file
 * @param isHall whether a surface may be a transparent mirror, which splits rays
 * @param surfaces how many there are
 */
record NastyScene(long seed, String text, boolean isHall, int surfaces) {
    private static final int MOST_FOR_EXACT_SHADOWS = 24;

    /** The same for the same seed. */
    static NastyScene of(long seed) {
        NastySceneWriter writer = new NastySceneWriter(seed);
        return new NastyScene(seed, writer.text(), writer.isHall(), writer.surfaces());
    }

    Scene scene() {
        try {
            return SceneParser.parse("nasty scene", text.getBytes(StandardCharsets.UTF_8), ForkJoin.sequential()).scene();
        } catch (RayTracerException wrong) {
            throw new IllegalStateException("not a scene:\n" + text + wrong.getMessage(), wrong);
        }
    }

    /** How it is drawn: now and then with smooth edges, exact or opaque shadows. */
    RenderSettings settings() {
        SplittableRandom random = new SplittableRandom(~seed);
        RenderSettings settings = RenderSettings.DEFAULT.withSize(NastyDrawing.SIZE, NastyDrawing.SIZE)
            .withWorkers(1, NastyDrawing.SIZE).withSeed(seed);
        if (random.nextInt(4) == 0) {
            settings = settings.withShadowMode(ShadowMode.ALL_SURFACES_STOP_LIGHT);
        }
        if (!isHall && surfaces <= MOST_FOR_EXACT_SHADOWS && random.nextInt(3) == 0) {
            settings = settings.withShadowMethod(new ShadowMethod.Exact());
        }
        return isHall || random.nextInt(4) != 0 ? settings
            : settings.withSampling(new PixelGrid(2 + random.nextInt(2), PixelGrid.Where.EDGES));
    }
}
