package raytracing;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.UnaryOperator;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

/**
 * Triangles that close off a part of space: neighbours share their corners, to the last bit, and so their edges.
 *
 * @param corners of all triangles
 * @param faces the numbers of the three corners of each
 * @param eyes places inside, on planes of symmetry where there are some
 */
record ClosedMesh(String name, List<Vector> corners, List<int[]> faces, List<Vector> eyes) {
    private static final double GOLDEN = (1 + Math.sqrt(5)) / 2;
    private static final double[][] ICOSAHEDRON = {
        {-1, GOLDEN, 0}, {1, GOLDEN, 0}, {-1, -GOLDEN, 0}, {1, -GOLDEN, 0}, {0, -1, GOLDEN}, {0, 1, GOLDEN},
        {0, -1, -GOLDEN}, {0, 1, -GOLDEN}, {GOLDEN, 0, -1}, {GOLDEN, 0, 1}, {-GOLDEN, 0, -1}, {-GOLDEN, 0, 1}};
    private static final int[][] ICOSAHEDRON_FACES = {
        {0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
        {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8}, {3, 8, 9}, {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}};

    /** Whose corners are exact. */
    static ClosedMesh tetrahedron() {
        return of("tetrahedron", new double[][] {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
            new int[][] {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}, eyesAround(0.2));
    }

    static ClosedMesh octahedron() {
        return of("octahedron", new double[][] {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
            new int[][] {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
            eyesAround(0.25));
    }

    /** A cube whose sides are two triangles each. */
    static ClosedMesh cube() {
        return of("cube", new double[][] {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1},
            {-1, 1, 1}, {1, 1, 1}}, new int[][] {{0, 1, 3}, {0, 3, 2}, {4, 7, 5}, {4, 6, 7}, {0, 5, 1}, {0, 4, 5}, {2, 3, 7},
            {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}}, eyesAround(0.5));
    }

    /** An icosahedron whose faces are divided in four, again and again, and whose corners are moved onto a sphere. */
    static ClosedMesh ball(int divisions) {
        List<Vector> corners = new ArrayList<>();
        for (double[] corner : ICOSAHEDRON) {
            corners.add(new Vector(corner[0], corner[1], corner[2]).unit());
        }
        List<int[]> faces = List.of(ICOSAHEDRON_FACES);
        for (int i = 0; i < divisions; i++) {
            faces = divided(faces, corners);
        }
        return new ClosedMesh("ball of " + faces.size(), corners, faces, eyesAround(0.5));
    }

    /** The same with every other corner pulled towards the middle: full of folds inwards and outwards. */
    static ClosedMesh star(int divisions) {
        ClosedMesh ball = ball(divisions);
        List<Vector> corners = new ArrayList<>();
        for (int i = 0; i < ball.corners.size(); i++) {
            corners.add(ball.corners.get(i).times(i % 3 == 0 ? 0.5 : 1));
        }
        return new ClosedMesh("star of " + ball.faces.size(), corners, ball.faces, eyesAround(0.1));
    }

    /** A ring, whose inside no eye sees as a whole. */
    static ClosedMesh ring(int around, int across) {
        List<Vector> corners = new ArrayList<>();
        List<int[]> faces = new ArrayList<>();
        for (int i = 0; i < around; i++) {
            for (int j = 0; j < across; j++) {
                double turn = 2 * Math.PI * i / around;
                double tilt = 2 * Math.PI * j / across;
                double distance = 1 + 0.3 * StrictMath.cos(tilt);
                corners.add(new Vector(distance * StrictMath.cos(turn), 0.3 * StrictMath.sin(tilt),
                    distance * StrictMath.sin(turn)));
                int next = (i + 1) % around * across;
                int right = (j + 1) % across;
                faces.add(new int[] {i * across + j, next + j, next + right});
                faces.add(new int[] {i * across + j, next + right, i * across + right});
            }
        }
        return new ClosedMesh("ring of " + faces.size(), corners, faces,
            List.of(new Vector(1, 0, 0), new Vector(0, 0.1, -1), new Vector(-0.6, 0.05, 0.8)));
    }

    private static ClosedMesh of(String name, double[][] corners, int[][] faces, List<Vector> eyes) {
        List<Vector> points = new ArrayList<>();
        for (double[] corner : corners) {
            points.add(new Vector(corner[0], corner[1], corner[2]));
        }
        return new ClosedMesh(name, points, List.of(faces), eyes);
    }

    private static List<Vector> eyesAround(double way) {
        return List.of(Vector.ZERO, new Vector(way, 0, 0), new Vector(0, -way / 2, way / 2), new Vector(0.61, 0.29, -0.42)
            .times(way));
    }

    private static List<int[]> divided(List<int[]> faces, List<Vector> corners) {
        Map<Long, Integer> middles = new HashMap<>();
        List<int[]> parts = new ArrayList<>();
        for (int[] face : faces) {
            int ab = middle(face[0], face[1], corners, middles);
            int bc = middle(face[1], face[2], corners, middles);
            int ca = middle(face[2], face[0], corners, middles);
            parts.addAll(List.of(new int[] {face[0], ab, ca}, new int[] {face[1], bc, ab}, new int[] {face[2], ca, bc},
                new int[] {ab, bc, ca}));
        }
        return parts;
    }

    private static int middle(int a, int b, List<Vector> corners, Map<Long, Integer> middles) {
        return middles.computeIfAbsent((long) Math.min(a, b) << 32 | Math.max(a, b), key -> {
            corners.add(Vectors.plus(corners.get(a), corners.get(b)).unit());
            return corners.size() - 1;
        });
    }

    /** The same mesh elsewhere: each corner is moved once, so neighbours still share it. */
    ClosedMesh moved(String how, UnaryOperator<Vector> motion) {
        return new ClosedMesh(name + how, corners.stream().map(motion).toList(), faces, eyes.stream().map(motion).toList());
    }

    /** A turn about the world's origin, by a random unit quaternion. */
    static UnaryOperator<Vector> turn(long seed) {
        Random random = new Random(seed);
        double w = random.nextGaussian();
        double x = random.nextGaussian();
        double y = random.nextGaussian();
        double z = random.nextGaussian();
        double s = 2 / (w * w + x * x + y * y + z * z);
        return p -> new Vector(
            (1 - s * (y * y + z * z)) * p.x() + s * (x * y - w * z) * p.y() + s * (x * z + w * y) * p.z(),
            s * (x * y + w * z) * p.x() + (1 - s * (x * x + z * z)) * p.y() + s * (y * z - w * x) * p.z(),
            s * (x * z - w * y) * p.x() + s * (y * z + w * x) * p.y() + (1 - s * (x * x + y * y)) * p.z());
    }

    /** How far the furthest corner is from the first eye. */
    double reach() {
        return corners.stream().mapToDouble(corner -> corner.minus(eyes.get(0)).length()).max().orElseThrow();
    }

    List<Surface> surfaces() {
        List<Surface> surfaces = new ArrayList<>();
        for (int[] face : faces) {
            surfaces.add(Triangle.of(corners.get(face[0]), corners.get(face[1]), corners.get(face[2]), 0));
        }
        return surfaces;
    }

    /** Places at which an eye looks: corners, the middles of edges as they are rounded, and middles of faces. */
    List<Vector> targets() {
        List<Vector> targets = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            int[] face = faces.get((int) ((long) i * (faces.size() - 1) / 2));
            Vector a = corners.get(face[0]);
            Vector middle = Vectors.plus(a, corners.get(face[1])).times(0.5);
            targets.addAll(List.of(a, middle, Vectors.plus(middle.times(2.0 / 3), 1.0 / 3, corners.get(face[2]))));
        }
        return targets;
    }

    @Override
    public String toString() {
        return name;
    }
}
