package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.film.Film;
import raytracing.parse.RayTracerException;
import raytracing.reference.ReferenceTracer;
import raytracing.render.RenderSettings;
import raytracing.scene.Scene;
import raytracing.scene.Settings;

/** The program draws what the reference tracer draws. */
class ReferenceTracerTest {
    private static final int SIZE = 40;

    /** Of a scene with thousands of surfaces, as every ray tests all of them. */
    private static final int SIZE_OF_A_CROWD = 12;
    private static final int CROWD = 1000;

    private static final int ROOMS_OF_A_KIND = 20;
    private static final int SIZE_OF_A_ROOM = 21;

    static Stream<Path> scenes() throws IOException {
        return SceneFiles.all();
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void ourScenesHaveTheSamePictures(Path file) throws RayTracerException, IOException {
        Scene scene = withoutAmbientLight(Steps.parseScene(file));
        assertSamePictures(scene, scene.surfaces().size() < CROWD ? SIZE : SIZE_OF_A_CROWD);
    }

    @ParameterizedTest
    @ValueSource(strings = {"Pool", "Room1", "Room1_fish", "Spheres"})
    void scenesOfTheCourseHaveTheSamePictures(String name) throws RayTracerException, IOException {
        Shared.require(Shared.SCENES);
        assertSamePictures(withoutAmbientLight(Steps.parseScene(Shared.SCENES.resolve(name + ".txt"))), SIZE);
    }

    /** Rays meet edges and corners exactly here, and surfaces touch or coincide. */
    @ParameterizedTest
    @EnumSource
    void randomRoomsHaveTheSamePictures(RandomRoom.Kind kind) {
        for (int seed = 0; seed < ROOMS_OF_A_KIND; seed++) {
            assertSamePictures(SceneText.scene(new RandomRoom(kind, seed).lines().toArray(new String[0])), SIZE_OF_A_ROOM);
        }
    }

    private static Scene withoutAmbientLight(Scene scene) {
        Settings settings = scene.settings();
        return new Scene(scene.camera(),
            new Settings(settings.background(), settings.shadowRayRoot(), settings.maxReflections(), 0),
            scene.materials(), scene.surfaces(), scene.lights());
    }

    /** To the last bit, unless mirrors are transparent: the program adds up the light of their rays in another order. */
    private static void assertSamePictures(Scene scene, int size) {
        RenderSettings settings = RenderSettings.DEFAULT.withSize(size, size);
        Film expected = new ReferenceTracer(scene, size, size, settings.seed()).draw();
        Film found = Steps.renderScene(scene, settings);
        boolean hasTransparentMirrors = scene.materials().stream()
            .anyMatch(material -> material.transparency() > 0 && !material.reflection().isBlack());
        if (hasTransparentMirrors) {
            PictureDifference difference = new PictureDifference(found.toImage(), expected.toImage());
            assertTrue(difference.largest() <= 1, difference::toString);
        } else {
            for (int i = 0; i < size * size; i++) {
                assertEquals(expected.get(i % size, i / size), found.get(i % size, i / size),
                    "pixel " + i % size + ", " + i / size);
            }
        }
    }
}
