package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import raytracing.parse.RayTracerException;
import raytracing.scene.Scene;
import raytracing.timed.Hall;
import raytracing.timed.Knot;
import raytracing.timed.Nest;
import raytracing.timed.SceneLines;
import raytracing.timed.Sphereflake;

/** Every scene that is timed: the course's, which lie beside the checkout or are missing, ours, and made ones. */
public enum TimedScene {
    ROOM1("Room1", Origin.course("Room1")),
    ROOM1_FISH("Room1, fisheye", Origin.course("Room1_fish")),
    SPHERES("Spheres", Origin.course("Spheres")),
    POOL("Pool", Origin.course("Pool")),
    ROOM("room", Origin.ours("room")),
    BUBBLES("bubbles", Origin.ours("bubbles")),
    BOXES("boxes", Origin.ours("boxes")),
    CAROUSEL("carousel", Origin.ours("carousel")),
    ECLIPSE("eclipse", Origin.ours("eclipse")),
    FISHEYE_SCENE("fisheye_scene", Origin.ours("fisheye_scene")),
    INSIDE_SPHERE("inside_sphere", Origin.ours("inside_sphere")),
    MIRRORS("mirrors", Origin.ours("mirrors")),
    SUNFLOWER("sunflower", Origin.ours("sunflower")),
    THREE_LAMPS("three_lamps", Origin.ours("three_lamps")),
    NEST("nest", new Made(Nest::scene)),
    HALL("hall", new Made(Hall::scene)),
    FLAKE_91("sphereflake 91", Made.flake(2, 1)),
    FLAKE_820("sphereflake 820", Made.flake(3, 1)),
    FLAKE_7381("sphereflake 7,381", Made.flake(4, 1)),
    FLAKE_7381_SOFT("sphereflake 7,381, N 3", Made.flake(4, 3)),
    FLAKE_66430("sphereflake 66,430", Made.flake(5, 1)),
    FLAKE_597871("sphereflake 597,871", Made.flake(6, 1)),
    FLAKE_597871_SOFT("sphereflake 597,871, N 3", Made.flake(6, 3)),
    KNOT_100000("knot 100,000", Made.knot(625, 80, 1)),
    KNOT_100000_SOFT("knot 100,000, N 3", Made.knot(625, 80, 3)),
    KNOT_1000000("knot 1,000,000", Made.knot(2000, 250, 1));

    private final String title;
    private final Origin origin;

    TimedScene(String title, Origin origin) {
        this.title = title;
        this.origin = origin;
    }

    /** Where a scene comes from. */
    private interface Origin {
        Scene scene() throws IOException, RayTracerException;

        /** A file of it: the one that is there, or a new one in the folder. */
        Path file(Path folder) throws IOException;

        boolean isThere();

        static Origin course(String name) {
            return new Written(Shared.SCENES.resolve(name + ".txt"));
        }

        static Origin ours(String name) {
            return new Written(Path.of("scenes", name + ".txt"));
        }
    }

    private record Written(Path path) implements Origin {
        @Override
        public Scene scene() throws IOException, RayTracerException {
            return Steps.parseScene(path);
        }

        @Override
        public Path file(Path folder) {
            return path;
        }

        @Override
        public boolean isThere() {
            return Files.exists(path);
        }
    }

    private record Made(Maker maker) implements Origin {
        private interface Maker {
            Scene make();
        }

        static Origin flake(int levels, int shadowRayRoot) {
            return new Made(() -> Sphereflake.scene(levels, shadowRayRoot));
        }

        static Origin knot(int along, int around, int shadowRayRoot) {
            return new Made(() -> Knot.scene(along, around, shadowRayRoot));
        }

        @Override
        public Scene scene() {
            return maker.make();
        }

        @Override
        public Path file(Path folder) throws IOException {
            return Files.writeString(Files.createTempFile(folder, "made", ".txt"), SceneLines.of(scene()));
        }

        @Override
        public boolean isThere() {
            return true;
        }
    }

    String title() {
        return title;
    }

    Scene scene() throws IOException, RayTracerException {
        return origin.scene();
    }

    Path file(Path folder) throws IOException {
        return origin.file(folder);
    }

    boolean isThere() {
        return origin.isThere();
    }

    /** A sentence about those of these scenes that are missing, or nothing. */
    static String missing(List<TimedScene> scenes) {
        List<String> titles = scenes.stream().filter(scene -> !scene.isThere()).map(TimedScene::title).toList();
        return titles.isEmpty() ? "" : "Not measured, as the course's scenes are not beside the checkout: "
            + String.join(", ", titles) + ".\n";
    }

    /** A scene by its name in a command, in any letter case. */
    static Optional<TimedScene> named(String name) {
        return Stream.of(values()).filter(scene -> scene.name().equalsIgnoreCase(name)).findFirst();
    }
}
