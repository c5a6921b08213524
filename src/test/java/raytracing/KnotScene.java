package raytracing;

import java.io.IOException;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.StringJoiner;
import raytracing.math.Vector;
import raytracing.math.Vectors;

/**
 * Writes {@code scenes/knot.txt}: a closed mesh of triangles by a formula. {@link StrictMath} gives the same digits on every
 * machine; a corner has the same digits in all of its triangles, so no gap opens between them.
 */
final class KnotScene {
    static final Path FILE = Path.of("scenes", "knot.txt");

    /** Around the knot and around its tube. */
    static final int ROWS = 240;
    static final int CORNERS = 18;

    private static final int SIDES = 6;
    private static final int FIRST_MATERIAL = 2;
    private static final int DECIMALS = 3;

    /** The knot lies on a torus; its tube is six-sided, with round edges. */
    private static final double TORUS = 2;
    private static final double RING = 0.95;
    private static final double TUBE = 0.46;
    private static final double EDGES = 0.1;

    /** How the knot stands: tipped back, and above the floor. */
    private static final double TIP = StrictMath.toRadians(60);
    private static final double HEIGHT = 1.98;

    private static final String HEAD = """
        # A trefoil knot of 8640 triangles above a polished floor: a band with six sides, one for each colour but the
        # ivory, which has two. Follow one of them: after one round through the whole knot it is back where it began.
        #
        # Shows off a mesh. No one wrote it by hand: "gradle mesh" writes this file. With t and a from 0 to 360 degrees,
        #   the knot runs along  p = ((2 + 0.95 cos 3t) cos 2t,  (2 + 0.95 cos 3t) sin 2t,  0.95 sin 3t),
        #   around it is a tube  p + 0.46 (1 + 0.1 cos 6a) (n cos(a + t) + b sin(a + t)),
        # where n = (cos 3t cos 2t, cos 3t sin 2t, sin 3t) is perpendicular to the knot, and b to both. 240 steps of t times
        # 18 of a are the corners. Then the knot is tipped back by 60 degrees and raised by 1.98.

        #    position       look-at        up        distance  width
        cam  0 4.7 -9       0.15 1.74 0    0 1 0     1         0.82

        #    background       N  recursion
        set  0.02 0.02 0.03   7  2

        #    diffuse           specular        reflection        phong  transparency
        # 1 the floor; 2 to 7: turquoise, blue, ivory, red, saffron, ivory
        mtl  0.34 0.32 0.38    0.2 0.2 0.2     0.22 0.23 0.26    200    0
        mtl  0.08 0.52 0.58    0.5 0.5 0.5     0    0    0        60    0
        mtl  0.14 0.24 0.62    0.5 0.5 0.5     0    0    0        60    0
        mtl  0.94 0.88 0.76    0.5 0.5 0.5     0    0    0        60    0
        mtl  0.88 0.24 0.20    0.5 0.5 0.5     0    0    0        60    0
        mtl  0.98 0.64 0.16    0.5 0.5 0.5     0    0    0        60    0
        mtl  0.94 0.88 0.76    0.5 0.5 0.5     0    0    0        60    0

        # A warm lamp at the left, and a faint cool one at the right without shadows.
        #    position     colour            specular  shadow  width
        lgt  -5 11 -6     1.00 0.92 0.80    1         1       1
        lgt   9  5 -5     0.30 0.36 0.54    0.3       0       0

        # The floor.
        pln  0 1 0   0   1

        # The knot.
        #    three corners, material
        """;

    private KnotScene() {
    }

    /** The text of the file. */
    static String text() {
        StringBuilder text = new StringBuilder(HEAD);
        for (int row = 0; row < ROWS; row++) {
            for (int corner = 0; corner < CORNERS; corner++) {
                String here = corner(row, corner);
                String across = corner(row + 1, corner + 1);
                int material = FIRST_MATERIAL + corner * SIDES / CORNERS;
                text.append(line(here, corner(row + 1, corner), across, material));
                text.append(line(here, across, corner(row, corner + 1), material));
            }
        }
        return text.toString();
    }

    private static String line(String a, String b, String c, int material) {
        return "trg " + a + "  " + b + "  " + c + "  " + material + "\n";
    }

    /** A corner of the mesh as it stands in the file; after the last row and after the last corner come the first. */
    private static String corner(int row, int corner) {
        Vector point = onTheTube(2 * Math.PI * (row % ROWS) / ROWS, 2 * Math.PI * (corner % CORNERS) / CORNERS);
        double sine = StrictMath.sin(TIP);
        double cosine = StrictMath.cos(TIP);
        return new StringJoiner(" ").add(decimal(point.x()))
            .add(decimal(HEIGHT + point.y() * cosine - point.z() * sine))
            .add(decimal(point.y() * sine + point.z() * cosine)).toString();
    }

    private static Vector onTheTube(double t, double a) {
        double cos2 = StrictMath.cos(2 * t);
        double sin2 = StrictMath.sin(2 * t);
        double cos3 = StrictMath.cos(3 * t);
        double sin3 = StrictMath.sin(3 * t);
        double reach = TORUS + RING * cos3;
        Vector n = new Vector(cos3 * cos2, cos3 * sin2, sin3);
        Vector along = new Vector(-2 * reach * sin2 - 3 * RING * sin3 * cos2, 2 * reach * cos2 - 3 * RING * sin3 * sin2,
            3 * RING * cos3);
        Vector b = along.cross(n).unit();
        double radius = TUBE * (1 + EDGES * StrictMath.cos(SIDES * a));
        Vector fromTheMiddle = Vectors.plus(n.times(radius * StrictMath.cos(a + t)), radius * StrictMath.sin(a + t), b);
        return Vectors.plus(new Vector(reach * cos2, reach * sin2, RING * sin3), fromTheMiddle);
    }

    private static String decimal(double value) {
        return BigDecimal.valueOf(Math.round(value * 1000), DECIMALS).toPlainString();
    }

    /**
     * Writes the file.
     *
     * @param arguments none
     */
    public static void main(String[] arguments) throws IOException {
        Files.writeString(FILE, text(), StandardCharsets.US_ASCII);
    }
}
