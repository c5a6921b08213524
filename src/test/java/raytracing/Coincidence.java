package raytracing;

import java.util.List;

/**
 * Two surfaces that coincide where they are seen, exactly as their numbers are written. Where one of them is moved away
 * from the eye, by a billionth, no rule is needed to say that the other is seen.
 *
 * @param first scene line without material
 * @param second scene line without material
 * @param firstBehind the first, moved
 * @param secondBehind the second, moved
 * @param side from where they are seen
 */
record Coincidence(String first, String second, String firstBehind, String secondBehind, Side side) {
    /**
     * Where the surfaces are seen from.
     *
     * @param eyes scene lines of cameras, each looking at them
     * @param lamps places of lamps, at the eyes and elsewhere on the same side
     * @param panes scene lines without material: bodies to look through, one for each eye
     * @param mirror a plane opposite to them, without material
     * @param mirrored a camera that looks at their image in the mirror
     */
    record Side(List<String> eyes, List<String> lamps, List<String> panes, String mirror, String mirrored) {
        static final Side ABOVE = new Side(
            List.of("cam 2.2 2.6 -4  0 1 0  0 1 0  1 1", "cam 0 4 0  0 1 0  0 0 1  1 1",
                "cam 1.5 1.4 2  0.25 1 0.125  0 1 0  1 2"),
            List.of("2.2 2.6 -4", "0 4 0", "1.5 1.4 2", "0 4.5 -1"),
            List.of("box 1.1 1.8 -2 0.9", "sph 0 3 0 0.7", "sph 1.5 1.4 2 0.25"),
            "pln 0 1 0 5", "cam 2.2 2.6 -4  0 9 0  0 1 0  1 0.5");
        static final Side FRONT = new Side(
            List.of("cam 1.3 2 -2  0 1 4  0 1 0  1 1", "cam 0 1 -3  0 1 4  0 1 0  1 0.7"),
            List.of("1.3 2 -2", "0 1 -3"),
            List.of("sph 0.7 1.5 1 1", "box 0 1 0 2"),
            "pln 0 0 1 -5", "cam 1.3 2 -2  0 1 -14  0 1 0  1 0.5");
    }

    static Coincidence above(String first, String firstBehind, String second, String secondBehind) {
        return new Coincidence(first, second, firstBehind, secondBehind, Side.ABOVE);
    }

    static Coincidence inFront(String first, String firstBehind, String second, String secondBehind) {
        return new Coincidence(first, second, firstBehind, secondBehind, Side.FRONT);
    }

    /** The same with the second surface first. */
    Coincidence swapped() {
        return new Coincidence(second, first, secondBehind, firstBehind, side);
    }

    @Override
    public String toString() {
        return first + " before " + second;
    }
}
