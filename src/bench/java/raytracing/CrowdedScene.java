package raytracing;

import java.util.List;
import java.util.Random;
import java.util.function.IntFunction;

/** Scenes with very many of one thing, whose number may be chosen: what is asked is how time and memory grow with it. */
enum CrowdedScene {
    BOXES("boxes in a field", 50_000, 100_000, CrowdedScene::boxes),
    PLANES("planes around a room", 5_000, 10_000, count -> planes(count, 8, 3)),
    PLANES_THROUGH("planes through a room", 5_000, 10_000, count -> planes(count, 0, 10)),
    LIGHTS("wide lights over three bodies", 2_500, 5_000, count -> lights(count, 0.5)),
    MANY_LIGHTS("point lights, 8 threads, 512 MiB of heap", 10_000, 20_000, count -> lights(count, 0)) {
        @Override
        List<String> javaOptions() {
            return List.of("-Xmx512m");
        }

        @Override
        List<String> programOptions() {
            return List.of("--threads", "8");
        }
    },
    NESTED("nested transparent balls", 150, 300, count -> nested(count, 0, 0.985)),
    MORE_NESTED("the same", 300, 600, count -> nested(count, 0, 0.985)),
    NESTED_MIRRORS("nested transparent balls, faint mirrors", 38, 75, count -> nested(count, 0.1, 0.9)),
    RECURSION("recursion between two mirrors", 500, 1_000, CrowdedScene::recursion),
    HALL_OF_PLANES("planes of transparent mirrors", 6, 12, CrowdedScene::hallOfPlanes),
    HALL_OF_BALLS("concentric transparent mirrors", 10, 20, CrowdedScene::hallOfBalls);

    private static final String FLOOR = "mtl 0.5 0.5 0.5  0 0 0  0 0 0  1 0\n";
    private static final String SHINY = "mtl 0.7 0.6 0.5  0.3 0.3 0.3  0.1 0.1 0.1  30 0\n";

    private final String title;
    private final int half;
    private final int count;
    private final IntFunction<String> maker;

    CrowdedScene(String title, int half, int count, IntFunction<String> maker) {
        this.title = title;
        this.half = half;
        this.count = count;
        this.maker = maker;
    }

    String title() {
        return title;
    }

    /** How many there are, and how many in a scene of half as many. */
    int count() {
        return count;
    }

    int half() {
        return half;
    }

    /** The text of a scene with so many things. */
    String text(int things) {
        return maker.apply(things);
    }

    /** Options of the virtual machine. */
    List<String> javaOptions() {
        return List.of();
    }

    /** Options of the program. */
    List<String> programOptions() {
        return List.of();
    }

    private static String boxes(int count) {
        Random random = new Random(1);
        int row = (int) Math.sqrt(count);
        double step = 20.0 / row;
        StringBuilder scene = new StringBuilder("cam 0 6 -20  0 0 0  0 1 0  1 1\nset 0.4 0.5 0.7  2 3\n" + SHINY + FLOOR
            + "pln 0 1 0 0 2\nlgt 10 20 -10  0.8 0.8 0.8  1 1 2\nlgt -15 10 0  0.4 0.4 0.5  1 1 0\n");
        for (int i = 0; i < count; i++) {
            line(scene, "box", (i % row - row / 2 + 0.4 * random.nextDouble()) * step, 1.5 * step * random.nextDouble(),
                (i / row - row / 2 + 0.4 * random.nextDouble()) * step, 0.55 * step, 1);
        }
        return scene.toString();
    }

    /** Around a ball, at a distance of at least {@code near} and by up to {@code more} further. */
    private static String planes(int count, double near, double more) {
        Random random = new Random(2);
        StringBuilder scene = new StringBuilder("cam 0 0.3 -5  0 0 0  0 1 0  1 1.2\nset 0.4 0.5 0.7  2 3\n" + SHINY
            + "sph 0 0 0  1  1\nlgt 4 5 -4  0.8 0.8 0.8  1 1 1\nlgt -3 3 -2  0.4 0.4 0.5  1 1 0\n");
        for (int i = 0; i < count; i++) {
            double[] normal = direction(random);
            line(scene, "pln", normal[0], normal[1], normal[2], -near - more * random.nextDouble() * random.nextDouble(), 1);
        }
        return scene.toString();
    }

    private static String lights(int count, double width) {
        Random random = new Random(3);
        StringBuilder scene = new StringBuilder("cam 0 3 -7  0 0.6 0  0 1 0  1 0.8\nset 0.1 0.1 0.1  2 2\n" + SHINY + FLOOR
            + "pln 0 1 0 0 2\nsph 0 1 0 1 1\nsph -1.8 0.6 -0.5 0.6 1\nbox 1.8 0.5 0 1 1\n");
        for (int i = 0; i < count; i++) {
            double[] place = direction(random);
            double color = 1.5 / count;
            line(scene, "lgt", 8 * place[0], 8 * Math.abs(place[1]), 8 * place[2], color, color, color, 1, 1, width);
        }
        return scene.toString();
    }

    /** Each ball inside the one before. */
    private static String nested(int count, double reflection, double transparency) {
        StringBuilder scene = new StringBuilder("cam 0 3 -9  0 0.5 0  0 1 0  1 0.8\nset 0.5 0.6 0.8  2 4\n" + FLOOR
            + "pln 0 1 0 -2.1 1\nlgt 5 7 -6  0.6 0.6 0.6  1 1 1\nlgt -6 6 -3  0.4 0.4 0.4  1 1 0\n");
        line(scene, "mtl", 0.9, 0.4, 0.3, 0.5, 0.5, 0.5, reflection, reflection, reflection, 40, transparency);
        for (int i = 0; i < count; i++) {
            line(scene, "sph", 0, 0, 0, 2.0 * (count - i) / count, 2);
        }
        return scene.toString();
    }

    private static String recursion(int reflections) {
        return "cam 0.3 0.2 -0.5  0.2 0.1 1  0 1 0  1 1\nset 0.1 0.1 0.2  2 " + reflections
            + "\nmtl 0.01 0.01 0.01  0 0 0  0.999 0.999 0.999  1 0\n" + SHINY
            + "pln 0 0 1 2 1\npln 0 0 1 -2 1\nsph 0 -0.5 1 0.4 2\nlgt 1 1.5 0  0.8 0.8 0.8  1 1 0.3\n";
    }

    private static String hallOfPlanes(int count) {
        Random random = new Random(5);
        StringBuilder scene = new StringBuilder("cam 0.3 0.2 -0.5  0 0 1  0 1 0  1 1\nset 0.05 0.1 0.15  1 10\n" + SHINY
            + "mtl 0.8 0.6 0.5  0.3 0.3 0.3  0.5 0.5 0.5  30 0.5\nsph 0 0 1 0.4 1\nlgt 0.5 0.8 0  0.5 0.5 0.5  1 1 0\n");
        for (int i = 0; i < count; i++) {
            double[] normal = direction(random);
            line(scene, "pln", normal[0], normal[1], normal[2], -2 - random.nextDouble(), 2);
        }
        return scene.toString();
    }

    private static String hallOfBalls(int count) {
        StringBuilder scene = new StringBuilder("cam 0.3 0.2 -0.5  0 0 1  0 1 0  1 1\nset 0.01 0.02 0.03  1 10\n"
            + "mtl 0 0 0  0 0 0  1 1 1  1 1\nlgt 0 30 0  1 1 1  1 1 0\n");
        for (int i = 1; i <= count; i++) {
            line(scene, "sph", 0, 0, 0, i, 1);
        }
        return scene.toString();
    }

    private static double[] direction(Random random) {
        double x = random.nextGaussian();
        double y = random.nextGaussian();
        double z = random.nextGaussian();
        double length = Math.sqrt(x * x + y * y + z * z);
        return new double[] {x / length, y / length, z / length};
    }

    /** A line of a scene; the last value may be the number of a material. */
    private static void line(StringBuilder scene, String code, double... values) {
        scene.append(code);
        for (double value : values) {
            scene.append(' ');
            if (value == Math.rint(value)) {
                scene.append((long) value);
            } else {
                scene.append(value);
            }
        }
        scene.append('\n');
    }
}
