package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import raytracing.ClosedRoom.Place;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.math.Vector;
import raytracing.render.RenderSettings;

/**
 * A ray that meets an edge shows what one of the surfaces there shows beside it. What is beside it, the same pixel of some
 * other pictures tells, in which the eye stands a little aside: so little that elsewhere all are the same.
 */
class EdgesSeenFromInsideTest {
    private static final int SIZE = 41;

    /** In the room's unit. */
    private static final double ASIDE = 2e-7;
    private static final double STEP_OF_A_PICTURE = 1.0 / 255;

    private static final List<Vector> FOUR_ASIDE = Stream.of(-1, 1)
        .flatMap(x -> Stream.of(-1, 1).map(y -> new Vector(x, y, 0))).toList();

    /** Where three mirrors meet, light goes over them in six orders, and four places do not see them all. */
    private static final List<Vector> TWELVE_ASIDE = FOUR_ASIDE.stream()
        .flatMap(at -> Stream.of(at, new Vector(at.x(), 2 * at.y(), 0), new Vector(2 * at.x(), at.y(), 0))).toList();

    /** Of planes and balls in turn. Cubes have the last: at an edge, one may be seen that beside it hides behind others. */
    private static final List<String> COLOURS = List.of("1 0.1 0.1", "0.1 0.8 0.2", "0.2 0.3 1", "0.9 0.8 0.1", "0.1 0.7 0.8",
        "0.8 0.2 0.9", "0.9 0.9 0.9");

    /** Here a ball's wall touches the edge of two planes: it may be seen in this one point, and nowhere beside it. */
    private static final List<Vector> ONLY_TOUCHED = List.of(new Vector(0, -3, 4), new Vector(3, 0, 4));

    static Stream<ClosedRoom> rooms() {
        return Stream.of(
            ClosedRoom.ofPlanes(Place.at(0, 0, 0, 1), 1), ClosedRoom.ofPlanes(Place.at(3, 7, 2, 0.1), 3),
            ClosedRoom.ofPlanes(Place.at(100.1, -7.3, 0.25, 1.0 / 3), -7), ClosedRoom.ofPyramid(Place.at(0, 0, 0, 1), 1),
            ClosedRoom.ofCubes(Place.at(0, 0, 0, 0.5), 3), ClosedRoom.ofCubes(Place.at(0, 0, 0, 0.5), 5),
            ClosedRoom.ofCubes(Place.at(6, 14, 4, 0.05), 3), ClosedRoom.ofCubes(Place.at(6, 14, 4, 0.05), 5),
            ClosedRoom.ofCubes(Place.at(1, 0, 0, 1.0 / 6), 3), ClosedRoom.ofBall(Place.at(0, 0, 0, 1), 1),
            ClosedRoom.ofBall(Place.at(3, 7, 2, 0.1), 3), ClosedRoom.ofCubesAndPlanes(Place.at(0, 0, 0, 1), 1),
            ClosedRoom.ofCubesAndPlanes(Place.at(0.3, 0.7, 0.2, 1e12), 3));
    }

    @ParameterizedTest
    @MethodSource("rooms")
    void anEdgeOfAMatteRoomShowsOneOfItsWalls(ClosedRoom room) {
        assertEdgesShowWhatIsBeside(room, List.of());
    }

    /** The first wall and all cubes are half a mirror, and show the others' edges. */
    @ParameterizedTest
    @MethodSource("rooms")
    void anEdgeInARoomWithAMirrorShowsOneOfItsWalls(ClosedRoom room) {
        assertEdgesShowWhatIsBeside(room, List.of(COLOURS.get(0), COLOURS.get(COLOURS.size() - 1)));
    }

    private static void assertEdgesShowWhatIsBeside(ClosedRoom room, List<String> mirrors) {
        List<String> wrong = new ArrayList<>();
        for (RoomView view : RoomView.of(room)) {
            int count = ONLY_TOUCHED.contains(view.target()) ? 0 : countOfOthers(room, view, mirrors);
            if (count > 0) {
                wrong.add(count + " of " + view);
            }
        }
        assertEquals(List.of(), wrong, "pixels unlike what is beside them in " + room);
    }

    private static int countOfOthers(ClosedRoom room, RoomView view, List<String> mirrors) {
        Film film = picture(room, view, Vector.ZERO, mirrors);
        List<Film> beside = new ArrayList<>();
        for (Vector aside : mirrors.isEmpty() ? FOUR_ASIDE : TWELVE_ASIDE) {
            beside.add(picture(room, view, aside.times(ASIDE), mirrors));
        }
        int count = 0;
        for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
            int x = pixel % SIZE;
            int y = pixel / SIZE;
            Color color = film.get(x, y);
            count += beside.stream().anyMatch(other -> isNear(color, other.get(x, y))) ? 0 : 1;
        }
        return count;
    }

    private static boolean isNear(Color color, Color other) {
        return Math.abs(color.red() - other.red()) <= STEP_OF_A_PICTURE
            && Math.abs(color.green() - other.green()) <= STEP_OF_A_PICTURE
            && Math.abs(color.blue() - other.blue()) <= STEP_OF_A_PICTURE;
    }

    /** The lamp stands in the room and near no wall. */
    private static Film picture(ClosedRoom room, RoomView view, Vector aside, List<String> mirrors) {
        List<String> lines = new ArrayList<>(List.of(room.cameraMoved(view.eye(), view.target(), view.width(), aside),
            "set 1 1 1  1 1", room.lamp(new Vector(0.3, 0.4, -0.2).times(room.reach()), 0)));
        for (String colour : COLOURS) {
            lines.add("mtl " + colour + "  0 0 0  " + (mirrors.contains(colour) ? "0.5 0.5 0.5" : "0 0 0") + "  1 0");
        }
        for (int i = 0; i < room.walls().size(); i++) {
            String wall = room.walls().get(i);
            lines.add(wall + " " + (wall.startsWith("box") ? COLOURS.size() : 1 + i % (COLOURS.size() - 1)));
        }
        return Steps.renderScene(SceneText.scene(lines.toArray(String[]::new)),
            RenderSettings.DEFAULT.withSize(SIZE, SIZE));
    }
}
