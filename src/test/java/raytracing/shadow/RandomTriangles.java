package raytracing.shadow;

import java.util.SplittableRandom;
import raytracing.Meshes;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.surface.Triangle;

/** Random scene lines in which triangles stand among other surfaces, or make meshes. */
final class RandomTriangles {
    private static final String[] OTHERS = {"sph", "box", "pln"};
    private final SplittableRandom random;
    private final int materials;

    /** With materials from 1 to a number. */
    RandomTriangles(SplittableRandom random, int materials) {
        this.random = random;
        this.materials = materials;
    }

    private int material() {
        return random.nextInt(1, materials + 1);
    }

    private Vector vector(double size) {
        return new Vector(random.nextDouble(-size, size), random.nextDouble(-size, size), random.nextDouble(-size, size));
    }

    private Vector rounded(int size) {
        return new Vector(random.nextInt(-size, size + 1), random.nextInt(-size, size + 1), random.nextInt(-size, size + 1));
    }

    private static String numbers(Vector v) {
        return " " + v.x() + " " + v.y() + " " + v.z() + " ";
    }

    /** So many surfaces, two of three of them triangles, with middles in a cube that is twice as wide as the spread. */
    String crowd(int size, double spread) {
        StringBuilder lines = new StringBuilder();
        for (int i = 0; i < size; i++) {
            String other = OTHERS[random.nextInt(OTHERS.length)];
            lines.append(random.nextInt(3) > 0 ? anywhere(spread) : other
                + numbers(vector(other.equals("pln") ? 1 : spread)) + spread * random.nextDouble(0.05, 0.5) + " " + material()
                + "\n");
        }
        return lines.toString();
    }

    /** One of all shapes, needles too, from a hundredth of the spread to a hundred times as large, most about as large. */
    private String anywhere(double spread) {
        double[] sizes = {0.01, 0.3, 0.5, 1, 100};
        double size = spread * sizes[random.nextInt(sizes.length)];
        Vector a = vector(spread);
        Vector b = Vectors.plus(a, vector(size));
        Vector c = random.nextInt(5) > 0 ? Vectors.plus(a, vector(size))
            : Vectors.plus(Vectors.plus(a, random.nextDouble(), b.minus(a)), vector(1e-9 * size));
        return Meshes.triangle(a, b, c, material());
    }

    /** Surfaces with round numbers: neighbours in one plane, twins, and edges and corners that many share. */
    String grid(int size) {
        StringBuilder lines = new StringBuilder();
        for (int i = 0; i < size; i++) {
            Vector a = rounded(2);
            Vector b = rounded(3);
            Vector c = rounded(3);
            if (!Triangle.areOnALine(a, b, c)) {
                lines.append(Meshes.triangle(a, b, c, material()));
                lines.append(random.nextBoolean() ? neighbour(a, b, c) : "");
            }
            String other = OTHERS[random.nextInt(OTHERS.length)];
            Vector place = rounded(2);
            lines.append(random.nextInt(3) > 0 || place.isZero() ? ""
                : other + numbers(place) + random.nextInt(1, 4) + " " + material() + "\n");
        }
        return lines.toString();
    }

    /** The other half of the parallelogram of a triangle, in the same plane; or the triangle once more. */
    private String neighbour(Vector a, Vector b, Vector c) {
        Vector across = Vectors.plus(b, c.minus(a));
        return random.nextInt(3) > 0 ? Meshes.triangle(c, b, across, material()) : Meshes.triangle(b, c, a, material());
    }

    /** Closed meshes, convex ones and one bent inwards, beside each other and in each other, on a floor of two triangles. */
    String meshes(double scale) {
        double wide = 8 * scale;
        double low = -2 * scale;
        return Meshes.hook(vector(scale), random.nextDouble(0.3, 1) * scale, material())
            + Meshes.ball(vector(2 * scale), random.nextDouble(0.3, 1) * scale, random.nextInt(3, 6), material())
            + Meshes.box(vector(2 * scale), random.nextDouble(0.3, 2) * scale, material())
            + Meshes.triangle(new Vector(-wide, low, -wide), new Vector(wide, low, -wide), new Vector(wide, low, wide), 1)
            + Meshes.triangle(new Vector(-wide, low, -wide), new Vector(wide, low, wide), new Vector(-wide, low, wide), 1);
    }
}
