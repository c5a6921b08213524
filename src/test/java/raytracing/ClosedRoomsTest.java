package raytracing;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.ClosedRoom.Place;
import raytracing.math.Vector;
import raytracing.shadow.ShadowMethod;

/**
 * No light enters a closed room, and no ray leaves it, not even where it meets an edge or a corner exactly. So all
 * pictures here are black.
 */
class ClosedRoomsTest {
    private static final int SIZE = 41;
    private static final int FEWER_PIXELS = 31;
    private static final int FEWEST_PIXELS = 21;
    private static final Place HERE = Place.at(0, 0, 0, 1);
    private static final ShadowMethod HARD = ShadowMethod.Sampled.withRoot(1);
    private static final ShadowMethod NINE_RAYS = ShadowMethod.Sampled.withRoot(3);
    private static final ShadowMethod EXACT = new ShadowMethod.Exact();
    private static final String DARK_SKY = "set 0 0 0  1 5";
    private static final double WIDE = 0.75;

    /** The rounding of a sum of areas. */
    private static final double ROUNDING = 1e-9;

    /** Sizes and places: some are exact as doubles, the others are rounded. */
    static List<Place> places() {
        return List.of(HERE, Place.at(2, -3, 5, 1), Place.at(3, 7, 2, 0.1), Place.at(1001, -73, 2.5, 0.1),
            Place.at(0, 0, 0, 1.0 / 3), Place.at(0.3, 0.7, 0.2, 1e-9), Place.at(3, 1, -7, 1e12));
    }

    static Stream<ClosedRoom> roomsOfPlanes() {
        Stream<ClosedRoom> ofAllFactors = Stream.of(3.0, 7.0, 0.1, -1.0, -5.0)
            .map(factor -> ClosedRoom.ofPlanes(HERE, factor));
        return Stream.concat(ofAllFactors, places().stream().flatMap(place ->
            Stream.of(ClosedRoom.ofPlanes(place, 1), ClosedRoom.ofPyramid(place, 1))));
    }

    static Stream<ClosedRoom> roomsOfCubes() {
        return places().stream().map(place -> new Place(place.middle().times(2), place.unit() / 2))
            .flatMap(place -> Stream.of(ClosedRoom.ofCubes(place, 3), ClosedRoom.ofCubes(place, 5)));
    }

    static Stream<ClosedRoom> otherRooms() {
        return places().stream().flatMap(place ->
            Stream.of(ClosedRoom.ofBall(place, 1), ClosedRoom.ofBall(place, -7), ClosedRoom.ofCubesAndPlanes(place, 3)));
    }

    @ParameterizedTest
    @MethodSource({"roomsOfPlanes", "roomsOfCubes", "otherRooms"})
    void noLampLightsAMatteRoomFromOutside(ClosedRoom room) {
        new DarkRoom(room, SIZE).drawAll("set 1 1 1  1 0", DarkRoom.MATTE, DarkRoom.NOTHING, HARD,
            DarkRoom.lampsAround(room, 0)).assertBlack();
    }

    @ParameterizedTest
    @MethodSource({"roomsOfPlanes", "roomsOfCubes", "otherRooms"})
    void noWideLampLightsAMatteRoomFromOutside(ClosedRoom room) {
        List<String> lamps = DarkRoom.lampsAround(room, WIDE);
        new DarkRoom(room, FEWEST_PIXELS).drawAll("set 1 1 1  1 0", DarkRoom.MATTE, DarkRoom.NOTHING, NINE_RAYS, lamps)
            .drawAll("set 1 1 1  1 0", DarkRoom.MATTE, ROUNDING, EXACT, lamps).assertBlack();
    }

    /** Where a ball's wall is turned away from the middle of a lamp by a right angle, half of the lamp stands behind it. */
    @Test
    void noWideLampShinesThroughTheWallOfABallAlongIt() {
        ClosedRoom ball = ClosedRoom.ofBallAlone(HERE);
        List<String> lamps = List.of(ball.lamp(new Vector(0, 0, -4), WIDE));
        List<RoomView> views = List.of(RoomView.along(Vector.ZERO, new Vector(1, 0, 0), 1));
        new DarkRoom(ball, SIZE).drawAll(views, "set 1 1 1  1 0", DarkRoom.MATTE, DarkRoom.NOTHING, NINE_RAYS, lamps)
            .drawAll(views, "set 1 1 1  1 0", DarkRoom.MATTE, ROUNDING, EXACT, lamps).assertBlack();
    }

    @ParameterizedTest
    @MethodSource({"roomsOfPlanes", "roomsOfCubes", "otherRooms"})
    void noLampLightsARoomOfMirrorsFromOutside(ClosedRoom room) {
        new DarkRoom(room, FEWER_PIXELS).drawAll(DARK_SKY, DarkRoom.HALF_A_MIRROR, DarkRoom.NOTHING, HARD,
            DarkRoom.lampsAround(room, 0)).assertBlack();
    }

    @ParameterizedTest
    @MethodSource({"roomsOfPlanes", "roomsOfCubes", "otherRooms"})
    void noMirrorShowsTheSkyOutsideTheRoom(ClosedRoom room) {
        new DarkRoom(room, FEWEST_PIXELS).drawAll(DarkRoom.SKY_BEHIND_12_REFLECTIONS, DarkRoom.HALF_A_MIRROR,
            DarkRoom.LESS_THAN_A_THOUSANDTH, HARD, List.of()).assertBlack();
    }

    /** Which wall of a joint stands first in the file decides which of them is seen there. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6})
    void theOrderOfTheWallsLetsNoLightIn(int seed) {
        for (ClosedRoom room : List.of(ClosedRoom.ofPlanes(HERE, 1), ClosedRoom.ofCubes(HERE, 3),
            ClosedRoom.ofBall(HERE, 1))) {
            List<String> walls = new ArrayList<>(room.walls());
            Collections.shuffle(walls, new Random(seed));
            ClosedRoom shuffled = room.withWalls(room.name() + ", shuffled with seed " + seed, walls);
            new DarkRoom(shuffled, SIZE)
                .drawAll("set 0 0 0  1 6", DarkRoom.HALF_A_MIRROR, DarkRoom.NOTHING, HARD, DarkRoom.lampsAround(shuffled, 0))
                .assertBlack();
        }
    }

    /** With exact numbers the planes of the joints contain the eye exactly, so that it looks into no joint. */
    static Stream<ClosedRoom> exactShells() {
        return Stream.of(HERE, Place.at(2, -6, 4, 1), Place.at(1, 3, -5, 0.5), Place.at(0, 0, 0, 0x1p40))
            .map(place -> ClosedRoom.ofCubes(place, 5));
    }

    @ParameterizedTest
    @MethodSource("exactShells")
    void anEyeInThePlaneOfAJointSeesNoLightInIt(ClosedRoom room) {
        List<RoomView> views = new ArrayList<>();
        for (Vector eye : List.of(new Vector(1, 0, 0), new Vector(1, 1, 0), new Vector(1, -1, 1))) {
            views.add(RoomView.along(eye, new Vector(0, 0, 1), 4));
            views.add(RoomView.along(eye, new Vector(1, 0, 0), 2));
            views.add(new RoomView(eye, new Vector(3, 1, 3), 1));
            views.add(new RoomView(eye, new Vector(1, 3, -3), 1));
        }
        DarkRoom dark = new DarkRoom(room, FEWER_PIXELS);
        dark.drawAll(views, "set 1 1 1  1 0", DarkRoom.MATTE, DarkRoom.NOTHING, HARD, DarkRoom.lampsAround(room, 0));
        dark.drawAll(views, DarkRoom.SKY_BEHIND_12_REFLECTIONS, DarkRoom.HALF_A_MIRROR, DarkRoom.LESS_THAN_A_THOUSANDTH, HARD,
            List.of(room.lamp(new Vector(1, 30, 0), 0))).assertBlack();
    }

    /** In pictures whose width is a power of two, all pixel centres are exact, and so are the diagonals of the screen. */
    @ParameterizedTest
    @ValueSource(ints = {32, 61, 64, 101})
    void noSizeOfThePictureFindsAnOpenJoint(int size) {
        for (ClosedRoom room : List.of(ClosedRoom.ofPlanes(HERE, 1), ClosedRoom.ofCubes(HERE, 3),
            ClosedRoom.ofPyramid(HERE, 1),
            ClosedRoom.ofBall(HERE, 1))) {
            new DarkRoom(room, size)
                .drawAll(DarkRoom.SKY_BEHIND_12_REFLECTIONS, DarkRoom.HALF_A_MIRROR, DarkRoom.LESS_THAN_A_THOUSANDTH, HARD,
                    List.of(room.lamp(new Vector(0, 5 * room.outside(), 0.2), 0)))
                .assertBlack();
        }
    }

    @Test
    void sixPlanesAroundTheEyeKeepALampOut() {
        ClosedRoom room = ClosedRoom.ofPlanes(HERE, 1);
        List<RoomView> straight = List.of(RoomView.along(Vector.ZERO, new Vector(0, 0, 1), 4));
        List<String> lamp = List.of(room.lamp(new Vector(0, 5, 0.2), 0));
        for (ShadowMethod method : List.of(HARD, EXACT)) {
            new DarkRoom(room, 101).drawAll(straight, "set 0 0 0  1 5", "mtl 1 1 1  0 0 0  0 0 0  1 0", ROUNDING, method,
                lamp).assertBlack();
        }
    }

    @Test
    void sixMirrorsThatSendOnFourFifthsKeepTwoLampsOut() {
        ClosedRoom room = ClosedRoom.ofPlanes(HERE, 1);
        List<RoomView> straight = List.of(RoomView.along(new Vector(0, 0, -0.5), new Vector(0, 0, 1), 2));
        new DarkRoom(room, 101).drawAll(straight, "set 0 0 0  1 100", "mtl 1 1 1  0 0 0  0.8 0.8 0.8  1 0", DarkRoom.NOTHING,
            HARD, List.of(room.lamp(new Vector(0, 5, 0), 0), room.lamp(new Vector(5, 0.5, 0.2), 0))).assertBlack();
    }

    @Test
    void twentySixBlackMirrorsKeepAWhiteSkyOut() {
        ClosedRoom room = ClosedRoom.ofCubes(Place.at(0, 0, 0, 0.5), 3);
        List<RoomView> straight = List.of(RoomView.along(Vector.ZERO, new Vector(0, 0, 1), 4));
        new DarkRoom(room, 101).drawAll(straight, "set 1 1 1  1 100", "mtl 0 0 0  0 0 0  0.5 0.5 0.5  1 0",
            DarkRoom.LESS_THAN_A_THOUSANDTH, HARD, List.of()).assertBlack();
    }

    /** Perfect mirrors: even after 60 reflections no light of the lamps has come in. */
    @ParameterizedTest
    @MethodSource("perfectMirrors")
    void noLampLightsARoomOfPerfectMirrors(ClosedRoom room) {
        new DarkRoom(room, FEWEST_PIXELS).drawAll("set 0 0 0  1 60", "mtl 1 1 1  0 0 0  1 1 1  1 0", DarkRoom.NOTHING, HARD,
            List.of(room.lamp(new Vector(0, 5 * room.outside(), 0.2), 0))).assertBlack();
    }

    static Stream<ClosedRoom> perfectMirrors() {
        return Stream.of(ClosedRoom.ofPlanes(HERE, 1), ClosedRoom.ofPyramid(HERE, 3), ClosedRoom.ofCubes(HERE, 3),
            ClosedRoom.ofCubes(Place.at(3, 7, 2, 0.1), 3), ClosedRoom.ofBall(HERE, 1),
            ClosedRoom.ofCubesAndPlanes(Place.at(0.3, 0.7, 0.2, 1.0 / 3), 1));
    }

    /** The walls are lit from outside only, so the estimate of the ambient light inside is 0. */
    @ParameterizedTest
    @MethodSource({"roomsOfPlanes", "roomsOfCubes", "otherRooms"})
    void noAmbientLightIsFoundInAMatteRoom(ClosedRoom room) {
        List<RoomView> straight = RoomView.of(room).subList(0, 1);
        new DarkRoom(room, FEWEST_PIXELS).drawAll(straight, "set 1 1 1  1 5", "mtl 0.8 0.8 0.8  0 0 0  0 0 0  1 0  1 1 1",
            DarkRoom.LESS_THAN_A_THOUSANDTH, HARD, DarkRoom.lampsAround(room, 0)).assertBlack();
    }
}
