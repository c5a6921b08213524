package raytracing;

import java.util.ArrayList;
import java.util.List;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/**
 * Walls without a gap around an empty space: no light enters, whatever is outside. Places are counted in units from the
 * middle, so that edges and corners have small whole numbers.
 *
 * @param name what a report calls it
 * @param middle of the empty space, world axes
 * @param unit its length in the scene
 * @param reach how many units the middle is away from the nearest wall along an axis, or less
 * @param outside how many units from the middle along an axis all bodies of the walls end
 * @param walls scene lines that lack their material
 * @param joints places on edges and corners, in units
 */
record ClosedRoom(String name, Vector middle, double unit, double reach, double outside, List<String> walls,
                  List<Vector> joints) {
    /** Looks along a joint of six planes, and into a corner of it. */
    private static final List<Vector> EDGES_OF_A_CUBE = List.of(new Vector(1, 1, 0), new Vector(0, -1, 1),
        new Vector(1, 1, 1), new Vector(-1, 1, -1));

    /**
     * Where a room lies, and how large it is.
     *
     * @param middle of the room in units
     * @param unit its length in the scene
     */
    record Place(Vector middle, double unit) {
        static Place at(double x, double y, double z, double unit) {
            return new Place(new Vector(x, y, z), unit);
        }

        /** The middle in the scene. */
        Vector inScene() {
            return middle.times(unit);
        }

        private Vector point(double x, double y, double z) {
            return Vectors.plus(middle, new Vector(x, y, z)).times(unit);
        }
    }

    /** A plane n.p = c around the middle, in units. */
    record Wall(double x, double y, double z, double c) {
        private String line(Place place, double factor) {
            Vector normal = new Vector(x, y, z).times(factor);
            return "pln" + DrawnPicture.numbers(normal) + place.unit() * (normal.dot(place.middle()) + factor * c);
        }
    }

    /** Six planes, 1 unit from the middle; {@code factor} is the length of their normals, below 0 turns them. */
    static ClosedRoom ofPlanes(Place place, double factor) {
        return ofPlanes("six planes", place, factor, 1, EDGES_OF_A_CUBE, new Wall(1, 0, 0, 1), new Wall(1, 0, 0, -1),
            new Wall(0, 1, 0, 1), new Wall(0, 1, 0, -1), new Wall(0, 0, 1, 1), new Wall(0, 0, 1, -1));
    }

    /** Four planes that lean together over a floor: 1 unit from the middle all of them, the top at 1.25. */
    static ClosedRoom ofPyramid(Place place, double factor) {
        return ofPlanes("pyramid", place, factor, 0.5,
            List.of(new Vector(0, 1.25, 0), new Vector(3, -1, 3), new Vector(1, 0.5, 1), new Vector(0, -1, 3)),
            new Wall(3, 4, 0, 5), new Wall(-3, 4, 0, 5), new Wall(0, 4, 3, 5), new Wall(0, 4, -3, 5), new Wall(0, -1, 0, 1));
    }

    private static ClosedRoom ofPlanes(String kind, Place place, double factor, double reach, List<Vector> joints,
                                       Wall... walls) {
        List<String> lines = new ArrayList<>();
        for (Wall wall : walls) {
            lines.add(wall.line(place, factor));
        }
        return new ClosedRoom(name(kind + ", normals times " + factor, place), place.inScene(), place.unit(), reach, 3, lines,
            joints);
    }

    /**
     * The shell of a block of cubes. A unit is half an edge, so the empty cube in the middle goes from 2 - across to
     * across - 2 along each axis.
     *
     * @param across how many cubes lie side by side, 3 or 5
     */
    static ClosedRoom ofCubes(Place place, int across) {
        List<String> cubes = new ArrayList<>();
        for (int x = 1 - across; x < across; x += 2) {
            for (int y = 1 - across; y < across; y += 2) {
                for (int z = 1 - across; z < across; z += 2) {
                    if (Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))) == across - 1) {
                        cubes.add(cube(place, x, y, z, 2));
                    }
                }
            }
        }
        double wall = across - 2;
        return new ClosedRoom(name(cubes.size() + " cubes", place), place.inScene(), place.unit(), wall, across, cubes,
            EDGES_OF_A_CUBE.stream().map(joint -> joint.times(wall)).toList());
    }

    /** Eight cubes in a ring, between a floor and a ceiling. */
    static ClosedRoom ofCubesAndPlanes(Place place, double factor) {
        List<String> walls = new ArrayList<>(List.of(new Wall(0, 1, 0, 0.75).line(place, factor)));
        for (int x = -2; x <= 2; x += 2) {
            for (int z = -2; z <= 2; z += 2) {
                if (x != 0 || z != 0) {
                    walls.add(cube(place, x, 0, z, 2));
                }
            }
        }
        walls.add(new Wall(0, 1, 0, -0.75).line(place, factor));
        return new ClosedRoom(name("ring of cubes between planes", place), place.inScene(), place.unit(), 0.75, 3, walls,
            List.of(new Vector(1, 0, 1), new Vector(1, 0.75, 0), new Vector(1, 0.75, 1), new Vector(-1, -0.75, -1)));
    }

    /**
     * The inside of a ball of 5 units, of which planes cut off parts: they meet its wall in (0, -3, 4) and the like. Each
     * lamp outside of it lies behind one of the planes.
     */
    static ClosedRoom ofBall(Place place, double factor) {
        List<String> walls = List.of(new Wall(0, 1, 0, -3).line(place, factor),
            "sph" + DrawnPicture.numbers(place.inScene()) + 5 * place.unit(), new Wall(1, 0, 0, 3).line(place, factor),
            new Wall(0, 0, 1, 4).line(place, factor), new Wall(0, 0, 1, -4).line(place, factor),
            new Wall(-4, 3, 0, 20).line(place, factor));
        return new ClosedRoom(name("ball cut by planes", place), place.inScene(), place.unit(), 2, 5, walls,
            List.of(new Vector(0, -3, 4), new Vector(3, 0, 4), new Vector(3, 4, 0), new Vector(-4, -3, 0),
                new Vector(3, -3, 0)));
    }

    /** The inside of a ball of 1 unit, without a joint. */
    static ClosedRoom ofBallAlone(Place place) {
        return new ClosedRoom(name("ball", place), place.inScene(), place.unit(), 0.5, 1,
            List.of("sph" + DrawnPicture.numbers(place.inScene()) + place.unit()), List.of());
    }

    private static String cube(Place place, double x, double y, double z, double edge) {
        return "box" + DrawnPicture.numbers(place.point(x, y, z)) + edge * place.unit();
    }

    private static String name(String kind, Place place) {
        return kind + ", unit " + place.unit() + " around" + DrawnPicture.numbers(place.middle()).stripTrailing();
    }

    /** The same room with its walls in another order. */
    ClosedRoom withWalls(String newName, List<String> newWalls) {
        return new ClosedRoom(newName, middle, unit, reach, outside, newWalls, joints);
    }

    /** A place in the scene. */
    Vector at(Vector units) {
        return Vectors.plus(middle, unit, units);
    }

    /**
     * A scene line of the camera.
     *
     * @param eye in units
     * @param target in units: the place in the middle of the picture
     * @param width of the screen at distance 1
     */
    String camera(Vector eye, Vector target, double width) {
        return camera(at(eye), at(target), target.minus(eye), width);
    }

    /** The same with the eye moved aside, in units; it looks the same way. */
    String cameraMoved(Vector eye, Vector target, double width, Vector aside) {
        return camera(Vectors.plus(at(eye), unit, aside), Vectors.plus(at(target), unit, aside), target.minus(eye), width);
    }

    private static String camera(Vector eye, Vector target, Vector view, double width) {
        String up = view.x() == 0 && view.z() == 0 ? "0 0 1" : "0 1 0";
        return "cam" + DrawnPicture.numbers(eye) + DrawnPicture.numbers(target) + up + "  1 " + width;
    }

    /** A scene line of a white lamp; place and width in units. */
    String lamp(Vector place, double width) {
        return "lgt" + DrawnPicture.numbers(at(place)) + "1 1 1  1 1 " + width * unit;
    }

    /** The scene lines of the walls, all of one material. */
    List<String> wallsOf(int material) {
        return walls.stream().map(wall -> wall + " " + material).toList();
    }

    @Override
    public String toString() {
        return name;
    }
}
