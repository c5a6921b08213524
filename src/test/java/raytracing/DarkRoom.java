package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import raytracing.color.Color;
import raytracing.film.Film;
import raytracing.math.Vector;
import raytracing.render.RenderSettings;
import raytracing.shadow.ShadowMethod;

/**
 * A closed room with all its lamps outside: every pixel must be black. The pictures that are not are collected, so that a
 * failure tells of all of them.
 */
final class DarkRoom {
    static final String MATTE = "mtl 1 1 1  0.5 0.5 0.5  0 0 0  2 0";
    static final String HALF_A_MIRROR = "mtl 1 1 1  0.5 0.5 0.5  0.5 0.5 0.5  2 0";

    /** Mirrors send on half of it 13 times, or it is left out below 1/4096. */
    static final String SKY_BEHIND_12_REFLECTIONS = "set 1 1 1  1 12";
    static final double NOTHING = 0;

    /** What may remain of a bright sky after many reflections; in a picture of 8 bits, twice as much is still 0. */
    static final double LESS_THAN_A_THOUSANDTH = 1e-3;

    private final ClosedRoom room;
    private final int size;
    private final List<String> lit = new ArrayList<>();

    DarkRoom(ClosedRoom room, int size) {
        this.room = room;
        this.size = size;
    }

    /** Lamps beyond the walls: aside, on axes and diagonals, in planes of walls and of joints. */
    static List<String> lampsAround(ClosedRoom room, double width) {
        double far = 4 * room.outside();
        double wall = room.reach();
        return List.of(new Vector(0, far, 0.2), new Vector(far, 0.5, 0.2), new Vector(0, 0, -far), new Vector(far, far, far),
            new Vector(-far, far, 0), new Vector(wall, -far, 0.3), new Vector(wall, wall, far), new Vector(-far, 1, -wall))
            .stream().map(place -> room.lamp(place, width)).toList();
    }

    /** Draws one picture and counts its pixels that are lit. */
    int draw(String name, double mostLight, ShadowMethod method, List<String> lines) {
        Film film = Steps.renderScene(SceneText.scene(lines.toArray(String[]::new)),
            RenderSettings.DEFAULT.withSize(size, size).withShadowMethod(method));
        int count = 0;
        for (int pixel = 0; pixel < size * size; pixel++) {
            Color color = film.get(pixel % size, pixel / size);
            boolean isDark = color.red() <= mostLight && color.green() <= mostLight && color.blue() <= mostLight;
            count += isDark ? 0 : 1;
        }
        if (count > 0) {
            lit.add(count + " of " + name);
        }
        return count;
    }

    /** Draws the room in many views under these settings and lamps. */
    DarkRoom drawAll(String settings, String material, double mostLight, ShadowMethod method, List<String> lamps) {
        return drawAll(RoomView.of(room), settings, material, mostLight, method, lamps);
    }

    DarkRoom drawAll(List<RoomView> views, String settings, String material, double mostLight, ShadowMethod method,
                     List<String> lamps) {
        for (RoomView view : views) {
            List<String> lines = new ArrayList<>(List.of(view.line(room), settings, material));
            lines.addAll(room.wallsOf(1));
            lines.addAll(lamps);
            draw(view.toString(), mostLight, method, lines);
        }
        return this;
    }

    void assertBlack() {
        assertEquals(List.of(), lit, "lit pixels in " + room + ", pictures of " + size + " x " + size + "\n");
    }
}
