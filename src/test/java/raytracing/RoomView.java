package raytracing;

import java.util.ArrayList;
import java.util.List;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/**
 * A look at the walls of a room, in its units. Eyes stand on planes of symmetry and look along axes or at joints, so that
 * many pixels meet edges and corners exactly.
 *
 * @param eye where it stands
 * @param target the place in the middle of the picture
 * @param width of the screen at distance 1
 */
record RoomView(Vector eye, Vector target, double width) {
    /** Views of any room: along axes and at its joints. */
    static List<RoomView> of(ClosedRoom room) {
        double half = room.reach() / 2;
        List<RoomView> views = new ArrayList<>(List.of(
            along(Vector.ZERO, new Vector(0, 0, 1), 4),
            along(new Vector(0, 0, -half), new Vector(0, 0, 1), 2),
            along(new Vector(half, half, -half), new Vector(0, 0, 1), 2),
            along(new Vector(half / 2, -half, 0), new Vector(1, 0, 0), 4),
            along(new Vector(0, half, 0), new Vector(0, -1, 0), 2)));
        for (Vector joint : room.joints()) {
            views.add(new RoomView(Vector.ZERO, joint, 1));
            views.add(new RoomView(new Vector(half / 2, -half, half / 4), joint, 0.5));
        }
        return views;
    }

    static RoomView along(Vector eye, Vector direction, double width) {
        return new RoomView(eye, Vectors.plus(eye, direction), width);
    }

    String line(ClosedRoom room) {
        return room.camera(eye, target, width);
    }
}
