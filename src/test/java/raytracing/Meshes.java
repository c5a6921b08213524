package raytracing;

import java.util.List;
import raytracing.math.Vector;

/** Scene lines of closed meshes. Corners that triangles share are the same numbers in all of them. */
public final class Meshes {
    private static final int[][] BOX_FACES = {
        {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

    /** An L, seen from the front, against the clock from the corner that is bent inwards. */
    private static final double[][] HOOK = {{0, 0}, {0, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 0}};

    private Meshes() {
    }

    /** One triangle; materials count from 1. */
    public static String triangle(Vector a, Vector b, Vector c, int material) {
        return "trg" + numbers(a) + numbers(b) + numbers(c) + " " + material + "\n";
    }

    private static String numbers(Vector point) {
        return " " + point.x() + " " + point.y() + " " + point.z();
    }

    /** The box of the scene line {@code box}, as 12 triangles. */
    public static String box(Vector centre, double edge, int material) {
        StringBuilder lines = new StringBuilder();
        for (int[] face : BOX_FACES) {
            addFan(List.of(corner(centre, edge, face[0]), corner(centre, edge, face[1]), corner(centre, edge, face[2]),
                corner(centre, edge, face[3])), material, lines);
        }
        return lines.toString();
    }

    private static Vector corner(Vector centre, double edge, int number) {
        double half = edge / 2;
        return new Vector(centre.x() + ((number & 1) == 0 ? -half : half), centre.y() + ((number & 2) == 0 ? -half : half),
            centre.z() + ((number & 4) == 0 ? -half : half));
    }

    private static void addFan(List<Vector> corners, int material, StringBuilder lines) {
        for (int i = 2; i < corners.size(); i++) {
            lines.append(triangle(corners.get(0), corners.get(i - 1), corners.get(i), material));
        }
    }

    /** A ball of rings between its poles, each twice as many squares as there are rings: 4 rings (rings - 1) triangles. */
    public static String ball(Vector centre, double radius, int rings, int material) {
        StringBuilder lines = new StringBuilder();
        for (int ring = 0; ring < rings; ring++) {
            for (int i = 0; i < 2 * rings; i++) {
                Vector above = onBall(centre, radius, ring, i, rings);
                Vector aboveNext = onBall(centre, radius, ring, i + 1, rings);
                Vector below = onBall(centre, radius, ring + 1, i, rings);
                Vector belowNext = onBall(centre, radius, ring + 1, i + 1, rings);
                if (ring > 0) {
                    lines.append(triangle(above, below, aboveNext, material));
                }
                if (ring < rings - 1) {
                    lines.append(triangle(aboveNext, below, belowNext, material));
                }
            }
        }
        return lines.toString();
    }

    private static Vector onBall(Vector centre, double radius, int ring, int i, int rings) {
        double down = Math.PI * ring / rings;
        double around = Math.PI * (i % (2 * rings)) / rings;
        double aside = ring == 0 || ring == rings ? 0 : radius * Math.sin(down);
        return new Vector(centre.x() + aside * Math.cos(around), centre.y() + radius * Math.cos(down),
            centre.z() + aside * Math.sin(around));
    }

    /** A hook that is twice as wide, as high and as deep as its size: 20 triangles, with an edge that is bent inwards. */
    public static String hook(Vector centre, double size, int material) {
        StringBuilder lines = new StringBuilder();
        for (double side : new double[] {-1, 1}) {
            addFan(List.of(onHook(centre, size, 0, side), onHook(centre, size, 1, side), onHook(centre, size, 2, side),
                onHook(centre, size, 3, side), onHook(centre, size, 4, side), onHook(centre, size, 5, side)), material, lines);
        }
        for (int i = 0; i < HOOK.length; i++) {
            int next = (i + 1) % HOOK.length;
            addFan(List.of(onHook(centre, size, i, -1), onHook(centre, size, next, -1), onHook(centre, size, next, 1),
                onHook(centre, size, i, 1)), material, lines);
        }
        return lines.toString();
    }

    private static Vector onHook(Vector centre, double size, int corner, double side) {
        return new Vector(centre.x() + size * HOOK[corner][0], centre.y() + size * HOOK[corner][1], centre.z() + side * size);
    }
}
