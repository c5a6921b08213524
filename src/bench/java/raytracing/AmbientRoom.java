package raytracing;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import raytracing.estimate.AmbientScenes;
import raytracing.parse.RayTracerException;
import raytracing.scene.Scene;

/** Rooms on which estimates of ambient light are measured. */
enum AmbientRoom {
    ROOM1("Room1, closed") {
        @Override
        Optional<Scene> scene() throws IOException, RayTracerException {
            return AmbientScenes.room1();
        }
    },
    OPEN("open, bright sky") {
        @Override
        Optional<Scene> scene() {
            return Optional.of(AmbientScenes.open());
        }
    },
    HALF_CLOSED("half closed") {
        @Override
        Optional<Scene> scene() {
            return Optional.of(AmbientScenes.halfClosed());
        }
    },
    FURNACE("white furnace, 0.5") {
        @Override
        Optional<Scene> scene() {
            return Optional.of(AmbientScenes.furnace(0.5));
        }
    },
    ARCADE("arcade") {
        @Override
        Optional<Scene> scene() throws IOException, RayTracerException {
            return ours("arcade");
        }
    },
    STUDIO("studio") {
        @Override
        Optional<Scene> scene() throws IOException, RayTracerException {
            return ours("studio");
        }
    };

    private final String title;

    AmbientRoom(String title) {
        this.title = title;
    }

    private static Optional<Scene> ours(String name) throws IOException, RayTracerException {
        return Optional.of(Steps.parseScene(Path.of("scenes", name + ".txt")));
    }

    /** None if it is not there. */
    abstract Optional<Scene> scene() throws IOException, RayTracerException;

    /** Those that are there, by their titles, in order. */
    static Map<String, Scene> scenes() throws IOException, RayTracerException {
        Map<String, Scene> scenes = new LinkedHashMap<>();
        for (AmbientRoom room : values()) {
            Optional<Scene> scene = room.scene();
            if (scene.isPresent()) {
                scenes.put(room.title, scene.get());
            }
        }
        return scenes;
    }

    /** A sentence about what is not there, or nothing. */
    static String missing() throws IOException, RayTracerException {
        return ROOM1.scene().isPresent() ? "" : "Not measured: Room1, as the course's scenes are not beside the checkout.\n";
    }
}
