package raytracing.outline;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import raytracing.Meshes;
import raytracing.color.Color;
import raytracing.math.Vector;
import raytracing.scene.Camera;
import raytracing.scene.Fisheye;
import raytracing.scene.Lens;
import raytracing.scene.Material;
import raytracing.scene.Pinhole;
import raytracing.scene.Scene;
import raytracing.scene.Settings;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

/** Random scenes whose outlines are hard to find, each with a camera in the middle of things. */
final class RandomViews {
    /** What is hard about a scene. */
    enum Kind {
        /** Anything anywhere, the eye inside some of it. */
        CROWD,
        /** Transparent bodies inside one another. */
        NESTED,
        /** Round numbers: bodies touch, share faces and coincide, and the eye lies in planes and faces. */
        GRID,
        /** Hundreds of bodies smaller than pixels before a wall. */
        DUST,
        /** The eye is in a room with boxes on its floor. */
        ROOM,
        /** More bodies than are tested one by one. */
        MANY,
        /** Thousands, of which a square may see more than it can keep. */
        HEAP,
        /** Triangles of all shapes among other things. */
        TRIANGLES,
        /** Triangles with round corners, which share edges and planes with each other and the eye. */
        TRIANGLE_GRID,
        /** Closed meshes, in each other and around the eye, of glass too. */
        MESHES,
        /** Triangles smaller than pixels before a wall. */
        SPLINTERS,
        /** More triangles than are tested one by one. */
        MANY_TRIANGLES,
        /** A mesh of so many triangles that a square may see more than it can keep. */
        FINE_MESH
    }

    private static final int MATERIALS = 3;
    private final SplittableRandom random;

    RandomViews(SplittableRandom random) {
        this.random = random;
    }

    /** With all lengths multiplied, and moved away from the origin of the world by so many units before that. */
    Scene scene(Kind kind, double scale, double far) {
        List<Surface> surfaces = new ArrayList<>();
        switch (kind) {
            case CROWD -> crowd(surfaces, random.nextInt(1, 12), 0.1, 2);
            case NESTED -> nested(surfaces);
            case GRID -> grid(surfaces);
            case DUST -> dust(surfaces);
            case ROOM -> room(surfaces);
            case MANY -> crowd(surfaces, 300, 0.02, 0.5);
            case HEAP -> crowd(surfaces, 3000, 0.01, 0.1);
            case TRIANGLES -> triangles(surfaces, random.nextInt(1, 12), 4);
            case TRIANGLE_GRID -> triangleGrid(surfaces);
            case MESHES -> meshes(surfaces);
            case SPLINTERS -> splinters(surfaces);
            case MANY_TRIANGLES -> triangles(surfaces, 300, 0.5);
            case FINE_MESH -> addAll(surfaces, Meshes.ball(vector(2), random.nextDouble(0.5, 3), 24, 1));
        }
        boolean isRound = kind == Kind.GRID || kind == Kind.TRIANGLE_GRID;
        boolean isDust = kind == Kind.DUST || kind == Kind.SPLINTERS;
        Vector eye = kind == Kind.TRIANGLE_GRID && random.nextInt(3) == 0 ? onTriangle((Triangle) surfaces.get(0))
            : isRound ? new Vector(random.nextInt(-4, 5), random.nextInt(-4, 5), random.nextInt(-4, 5))
            : isDust ? new Vector(0, 0, -10) : vector(kind == Kind.ROOM ? 1.8 : 4);
        Vector aim = isRound && random.nextBoolean() ? new Vector(eye.x(), eye.y(), eye.z() + 1)
            : isDust ? new Vector(0.1, 0.2, 5) : plus(eye, vector(1), 1);
        Vector away = new Vector(far, far / 3, -far / 7);
        double[] distances = {1, 1, 0.3, 3, 30};
        Camera camera = new Camera(plus(eye, away, 1).times(scale), plus(aim, away, 1).times(scale),
            new Vector(0.1, 1, 0.07), distances[random.nextInt(distances.length)] * random.nextDouble(0.8, 1.2),
            random.nextDouble(0.5, 2), lens());
        List<Surface> placed = new ArrayList<>();
        for (Surface surface : surfaces) {
            placed.add(placed(surface, scale, away));
        }
        return new Scene(camera, new Settings(Color.BLACK, 1, 1, 1), materials(), placed, List.of());
    }

    private Lens lens() {
        double[] ks = {-1, -0.7, -1e-9, 0, 1e-9, 0.5, 0.95};
        return random.nextBoolean() ? new Pinhole()
            : new Fisheye(random.nextBoolean() ? ks[random.nextInt(ks.length)] : random.nextDouble(-1, 1));
    }

    private static List<Material> materials() {
        List<Material> materials = new ArrayList<>();
        for (int i = 0; i < MATERIALS; i++) {
            materials.add(new Material(Color.BLACK, Color.BLACK, Color.BLACK, 1, i == 0 ? 0 : 0.5, Color.BLACK));
        }
        return materials;
    }

    private static Surface placed(Surface surface, double scale, Vector away) {
        return surface.accept(new Surface.Visitor<Surface>() {
            @Override
            public Surface visit(Sphere sphere) {
                return new Sphere(plus(sphere.centre(), away, 1).times(scale), scale * sphere.radius(), sphere.material());
            }

            @Override
            public Surface visit(Plane plane) {
                return new Plane(plane.normal(), scale * (plane.offset() + plane.normal().dot(away)), plane.material());
            }

            @Override
            public Surface visit(Box box) {
                return new Box(plus(box.centre(), away, 1).times(scale), scale * box.edge(), box.material());
            }

            @Override
            public Surface visit(Triangle triangle) {
                return Triangle.of(plus(triangle.a(), away, 1).times(scale), plus(triangle.b(), away, 1).times(scale),
                    plus(triangle.c(), away, 1).times(scale), triangle.material());
            }
        });
    }

    private static Vector plus(Vector a, Vector b, double factor) {
        return new Vector(a.x() + factor * b.x(), a.y() + factor * b.y(), a.z() + factor * b.z());
    }

    private Vector vector(double size) {
        return new Vector(random.nextDouble(-size, size), random.nextDouble(-size, size), random.nextDouble(-size, size));
    }

    private int material() {
        return random.nextInt(MATERIALS);
    }

    private void crowd(List<Surface> surfaces, int size, double least, double most) {
        for (int i = 0; i < size; i++) {
            int kind = size > 100 ? random.nextInt(4) : random.nextInt(5);
            double length = random.nextDouble(least, most);
            if (kind < 2) {
                surfaces.add(new Sphere(vector(4), length, material()));
            } else if (kind < 4) {
                surfaces.add(new Box(vector(4), 2 * length, material()));
            } else {
                surfaces.add(new Plane(vector(3), random.nextDouble(-9, 9), material()));
            }
        }
    }

    private void nested(List<Surface> surfaces) {
        Vector centre = vector(2);
        double size = random.nextDouble(1, 4);
        for (int i = 0; i < 6; i++) {
            size *= random.nextDouble(0.5, 1);
            boolean isOpaque = i == 5 && random.nextBoolean();
            surfaces.add(random.nextBoolean() ? new Sphere(plus(centre, vector(0.1), 1), size, isOpaque ? 0 : 1)
                : new Box(plus(centre, vector(0.1), 1), size, isOpaque ? 0 : 2));
        }
        surfaces.add(new Plane(vector(1), -9, 0));
    }

    private void grid(List<Surface> surfaces) {
        int size = random.nextInt(2, 9);
        for (int i = 0; i < size; i++) {
            Vector place = new Vector(random.nextInt(-2, 3), random.nextInt(-2, 3), random.nextInt(-2, 3));
            switch (random.nextInt(3)) {
                case 0 -> surfaces.add(new Sphere(place, random.nextInt(1, 4), material()));
                case 1 -> surfaces.add(new Box(place, random.nextInt(1, 4), material()));
                default -> surfaces.add(new Plane(place.isZero() ? new Vector(0, 1, 0) : place, random.nextInt(-3, 4),
                    material()));
            }
        }
    }

    private void dust(List<Surface> surfaces) {
        surfaces.add(new Plane(new Vector(0, 0, 1), 9, 0));
        for (int i = 0; i < 300; i++) {
            double radius = 0.1 * Math.scalb(1, -random.nextInt(1, 12));
            surfaces.add(random.nextInt(4) > 0 ? new Sphere(vector(4), radius, material())
                : new Box(vector(4), radius, material()));
        }
    }

    private void room(List<Surface> surfaces) {
        for (int side = -1; side < 2; side += 2) {
            surfaces.add(new Plane(new Vector(1, 0, 0), side * 2, 0));
            surfaces.add(new Plane(new Vector(0, 1, 0), side * 2, 0));
            surfaces.add(new Plane(new Vector(0, 0, 1), side * 2, 0));
        }
        for (int i = 0; i < 5; i++) {
            double edge = random.nextDouble(0.2, 1);
            double x = random.nextDouble(-1.5, 1.5);
            double z = random.nextDouble(-1.5, 1.5);
            surfaces.add(i % 2 == 0 ? new Box(new Vector(x, edge / 2 - 2, z), edge, material())
                : new Sphere(new Vector(x, edge / 2 - 2, z), edge / 2, material()));
        }
    }

    /** So many surfaces, of which nine in ten are triangles; the size is that of most. */
    private void triangles(List<Surface> surfaces, int count, double size) {
        double[] sizes = {0.01, 0.3, 1, 1, 100};
        crowd(surfaces, count / 10, 0.1, size);
        for (int i = 0; i < count; i++) {
            Vector a = vector(4);
            double length = size * sizes[random.nextInt(count > 100 ? sizes.length - 1 : sizes.length)];
            Vector b = plus(a, vector(length), 1);
            Vector c = random.nextInt(4) > 0 ? plus(a, vector(length), 1)
                : plus(plus(a, plus(b, a, -1), random.nextDouble()), vector(1e-7 * length), 1);
            surfaces.add(Triangle.of(a, b, c, material()));
        }
    }

    private Vector rounded(int size) {
        return new Vector(random.nextInt(-size, size + 1), random.nextInt(-size, size + 1), random.nextInt(-size, size + 1));
    }

    /** Each with the other half of its parallelogram, or a twin. */
    private void triangleGrid(List<Surface> surfaces) {
        surfaces.add(Triangle.of(new Vector(3, 1, -2), new Vector(-3, random.nextInt(-1, 4), 2), rounded(1), material()));
        for (int i = random.nextInt(2, 9); i > 0; i--) {
            Vector a = rounded(2);
            Vector b = rounded(3);
            Vector c = rounded(3);
            if (!Triangle.areOnALine(a, b, c)) {
                surfaces.add(Triangle.of(a, b, c, material()));
                surfaces.add(random.nextInt(3) > 0 ? Triangle.of(c, b, plus(b, plus(c, a, -1), 1), material())
                    : Triangle.of(b, a, c, material()));
            }
        }
        grid(surfaces);
    }

    /** A place within it or on its edge, exactly. */
    private Vector onTriangle(Triangle triangle) {
        Vector onEdge = plus(triangle.a().times(0.5), triangle.b(), 0.5);
        return random.nextBoolean() ? onEdge : plus(onEdge.times(0.5), triangle.c(), 0.5);
    }

    private void meshes(List<Surface> surfaces) {
        addAll(surfaces, Meshes.hook(vector(2), random.nextDouble(0.3, 1.5), 1 + material()));
        addAll(surfaces, Meshes.ball(vector(2), random.nextDouble(0.3, 2), random.nextInt(3, 7), 1 + material()));
        addAll(surfaces, Meshes.box(vector(2), random.nextDouble(0.3, 3), 1 + material()));
        addAll(surfaces, Meshes.box(new Vector(0, 0, 0), 12, 1));
    }

    private static void addAll(List<Surface> surfaces, String lines) {
        for (String line : lines.split("\n")) {
            double[] numbers = Arrays.stream(line.substring("trg ".length()).split(" ")).mapToDouble(Double::parseDouble)
                .toArray();
            surfaces.add(Triangle.of(new Vector(numbers[0], numbers[1], numbers[2]),
                new Vector(numbers[3], numbers[4], numbers[5]), new Vector(numbers[6], numbers[7], numbers[8]),
                (int) numbers[9] - 1));
        }
    }

    private void splinters(List<Surface> surfaces) {
        surfaces.add(new Plane(new Vector(0, 0, 1), 9, 0));
        for (int i = 0; i < 300; i++) {
            double size = 0.1 * Math.scalb(1, -random.nextInt(1, 12));
            Vector a = vector(4);
            surfaces.add(Triangle.of(a, plus(a, vector(size), 1), plus(a, vector(size), 1), material()));
        }
    }
}
