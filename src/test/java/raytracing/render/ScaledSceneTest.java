package raytracing.render;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.CommittedScenesTest;
import raytracing.Steps;
import raytracing.film.Film;
import raytracing.scene.Camera;
import raytracing.scene.Light;
import raytracing.scene.Scene;
import raytracing.shadow.ShadowMethod;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

/** A law of scenes without a unit: multiplying every length by a power of two changes no bit of the film. */
class ScaledSceneTest {
    private static final RenderSettings SMALL = RenderSettings.DEFAULT.withSize(80, 80);

    static Stream<Arguments> scenesAndScales() throws Exception {
        return CommittedScenesTest.scenes().flatMap(
            scene -> Stream.of(0x1p40, 0x1p-40).map(scale -> Arguments.of(scene, scale)));
    }

    @ParameterizedTest(name = "{0} times {1}")
    @MethodSource("scenesAndScales")
    void theFilmIsTheSameBitForBit(Path file, double scale) throws Exception {
        Scene scene = Steps.parseScene(file);
        RendererTest.assertSamePixels(Renderers.film(scene, SMALL),
            Renderers.film(scaled(scene, scale), SMALL));
    }

    /** So small that squares of lengths are no doubles any more, and so large. */
    @ParameterizedTest
    @MethodSource("raytracing.CommittedScenesTest#scenes")
    void alsoAtTheEndsOfTheRange(Path file) throws Exception {
        RenderSettings settings = SMALL.withSize(40, 40);
        Scene scene = Steps.parseScene(file);
        Film film = Renderers.film(scene, settings);
        RendererTest.assertSamePixels(film, Renderers.film(scaled(scene, 0x1p900), settings));
        RendererTest.assertSamePixels(film, Renderers.film(scaled(scene, 0x1p-900), settings));
    }

    @ParameterizedTest(name = "{0} times {1}")
    @MethodSource("scenesAndScales")
    void theSamePixelsAreRefinedInTheSameWay(Path file, double scale) throws Exception {
        RenderSettings smooth = SMALL.withSize(40, 40)
            .withSampling(new PixelGrid(2, PixelGrid.Where.EDGES));
        Scene scene = Steps.parseScene(file);
        RendererTest.assertSamePixels(Renderers.film(scene, smooth),
            Renderers.film(scaled(scene, scale), smooth));
    }

    @ParameterizedTest(name = "{0} times {1}")
    @MethodSource("scenesAndScales")
    void exactShadowsAreTheSameBitForBit(Path file, double scale) throws Exception {
        RenderSettings exact = SMALL.withShadowMethod(new ShadowMethod.Exact());
        Scene scene = Steps.parseScene(file);
        RendererTest.assertSamePixels(Renderers.film(scene, exact),
            Renderers.film(scaled(scene, scale), exact));
    }

    private static Scene scaled(Scene scene, double scale) {
        Camera camera = scene.camera();
        List<Surface> surfaces = scene.surfaces().stream().map(surface -> scaled(surface, scale)).toList();
        List<Light> lights = scene.lights().stream().map(light -> new Light(light.position().times(scale),
            light.color(), light.specularIntensity(), light.shadowIntensity(), light.width() * scale)).toList();
        return new Scene(new Camera(camera.position().times(scale), camera.lookAt().times(scale), camera.up(),
            camera.screenDistance() * scale, camera.screenWidth() * scale, camera.lens()), scene.settings(),
            scene.materials(), surfaces, lights);
    }

    private static Surface scaled(Surface surface, double scale) {
        if (surface instanceof Sphere sphere) {
            return new Sphere(sphere.centre().times(scale), sphere.radius() * scale, sphere.material());
        }
        if (surface instanceof Plane plane) {
            return new Plane(plane.normal(), plane.offset() * scale, plane.material());
        }
        if (surface instanceof Triangle triangle) {
            return Triangle.of(triangle.a().times(scale), triangle.b().times(scale), triangle.c().times(scale),
                triangle.material());
        }
        Box box = (Box) surface;
        return new Box(box.centre().times(scale), box.edge() * scale, box.material());
    }
}
