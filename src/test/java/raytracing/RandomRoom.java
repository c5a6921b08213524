package raytracing;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import raytracing.ClosedRoom.Place;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/**
 * A random closed room: its kind is given; its size and place, the order of its walls, what they are made of, what
 * stands in it, the eye and the lamps outside are random. Eyes and lamps stand on a coarse grid, so that many rays
 * meet edges and corners exactly.
 */
final class RandomRoom {
    /** What its walls are. */
    enum Kind { PLANES, PYRAMIDS, CUBES, BALLS_AND_PLANES, CUBES_AND_PLANES }

    private static final List<Double> UNITS = List.of(1.0, 0.5, 0.1, 1.0 / 3, 1e-9, 1e12, 7.0);
    private static final List<Vector> MIDDLES = List.of(Vector.ZERO, new Vector(2, -4, 6), new Vector(0.3, 0.7, 0.2),
        new Vector(100.1, -7.3, 0.25), new Vector(-0.6, 1001, 3));
    private static final List<Double> FACTORS = List.of(1.0, 3.0, 7.0, 0.1, -1.0, -5.0);
    private static final List<Double> WIDTHS = List.of(0.5, 1.0, 2.0, 4.0);
    private static final List<Double> LAMP_WIDTHS = List.of(0.0, 0.0, 0.75);

    /** How many steps the grid of eyes has from the middle to a wall. */
    private static final List<Integer> STEPS = List.of(2, 2, 5);

    private final Random random;
    private final ClosedRoom room;
    private final List<String> lines = new ArrayList<>();

    RandomRoom(Kind kind, long seed) {
        random = new Random(seed);
        Place place = new Place(one(MIDDLES), one(UNITS));
        ClosedRoom inOrder = inOrder(kind, place, one(FACTORS));
        List<String> walls = new ArrayList<>(inOrder.walls());
        if (random.nextBoolean()) {
            Collections.shuffle(walls, random);
        }
        room = inOrder.withWalls(inOrder.name() + ", seed " + seed, walls);
        boolean isMatte = random.nextBoolean();
        lines.addAll(List.of(camera(), "set 1 1 1  " + (1 + random.nextInt(2)) + " 12",
            isMatte ? DarkRoom.MATTE : DarkRoom.HALF_A_MIRROR, "mtl 1 0.5 1  1 1 1  0 0 0  3 0.5", DarkRoom.MATTE));
        lines.addAll(room.wallsOf(1));
        addContent();
        for (int i = 0; i < 3; i++) {
            lines.add(room.lamp(outside(), one(LAMP_WIDTHS)));
        }
    }

    private ClosedRoom inOrder(Kind kind, Place place, double factor) {
        Place ofHalfEdge = new Place(place.middle().times(2), place.unit() / 2);
        return switch (kind) {
            case PLANES -> ClosedRoom.ofPlanes(place, factor);
            case PYRAMIDS -> ClosedRoom.ofPyramid(place, factor);
            case CUBES -> ClosedRoom.ofCubes(ofHalfEdge, random.nextInt(4) == 0 ? 5 : 3);
            case BALLS_AND_PLANES -> ClosedRoom.ofBall(place, factor);
            case CUBES_AND_PLANES -> ClosedRoom.ofCubesAndPlanes(place, factor);
        };
    }

    ClosedRoom room() {
        return room;
    }

    /** The lines of the scene. */
    List<String> lines() {
        return lines;
    }

    private <T> T one(List<T> things) {
        return things.get(random.nextInt(things.size()));
    }

    private String camera() {
        int steps = one(STEPS);
        Vector eye = onGrid(steps).times(room.reach() / steps);
        if (random.nextBoolean()) {
            return room.camera(eye, one(room.joints()), one(WIDTHS));
        }
        Vector axis = one(List.of(new Vector(1, 0, 0), new Vector(0, -1, 0), new Vector(0, 0, 1), new Vector(-1, 0, 1)));
        return room.camera(eye, Vectors.plus(eye, axis), one(WIDTHS));
    }

    /** Whole coordinates, each with an absolute value below {@code most}. */
    private Vector onGrid(int most) {
        return new Vector(random.nextInt(2 * most - 1) - most + 1, random.nextInt(2 * most - 1) - most + 1,
            random.nextInt(2 * most - 1) - most + 1);
    }

    /** Nothing, or a glass or a matte body: in the middle, or a cube that stands in the corner of two or three walls. */
    private void addContent() {
        int material = 2 + random.nextInt(2);
        double half = room.reach() / 4;
        switch (random.nextInt(3)) {
            case 0 -> lines.add(body("sph", onGrid(3).times(half), half, material));
            case 1 -> lines.add(body("box", onGrid(4).times(half), 2 * half, material));
            default -> { }
        }
    }

    private String body(String code, Vector place, double length, int material) {
        return code + DrawnPicture.numbers(room.at(place)) + length * room.unit() + " " + material;
    }

    /** Beyond the walls along one axis at least, and on the grid of the joints. */
    private Vector outside() {
        double far = 4 * room.outside();
        Vector place = onGrid(4).times(room.reach());
        return switch (random.nextInt(6)) {
            case 0 -> new Vector(far, place.y(), place.z());
            case 1 -> new Vector(-far, place.y(), place.z());
            case 2 -> new Vector(place.x(), far, place.z());
            case 3 -> new Vector(place.x(), -far, place.z());
            case 4 -> new Vector(place.x(), place.y(), far);
            default -> new Vector(place.x(), place.y(), -far);
        };
    }
}
