package raytracing.render;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import raytracing.color.Color;
import raytracing.math.Vector;
import raytracing.scene.Camera;
import raytracing.scene.Fisheye;
import raytracing.scene.Lens;
import raytracing.scene.Light;
import raytracing.scene.Material;
import raytracing.scene.Pinhole;
import raytracing.scene.Scene;
import raytracing.scene.Settings;
import raytracing.surface.Box;
import raytracing.surface.Plane;
import raytracing.surface.Sphere;
import raytracing.surface.Surface;

/**
 * A random scene such as people write: a floor, mostly a wall, 3 to 30 balls and cubes of many sizes, specks among them, some
 * of mirrors and some of glass, in glass too; 1 to 3 lights, hard and soft. Without ambient light.
 */
public final class OrdinaryScene {
    private static final int LARGEST_SHADOW_RAY_ROOT = 6;

    private final SplittableRandom random;
    private final List<Material> materials = new ArrayList<>();
    private final List<Surface> surfaces = new ArrayList<>();
    private final List<Light> lights = new ArrayList<>();

    private OrdinaryScene(long seed) {
        random = new SplittableRandom(seed);
    }

    /** The scene of a number. */
    public static Scene of(long seed) {
        return new OrdinaryScene(seed).scene(3, 30);
    }

    /** The scene of a number, with at most so many balls and cubes, at least 3. */
    static Scene small(long seed, int mostBodies) {
        return new OrdinaryScene(seed).scene(3, mostBodies);
    }

    private Scene scene(int fewest, int most) {
        int kinds = random.nextInt(4, 9);
        for (int i = 0; i < kinds; i++) {
            materials.add(material());
        }
        addWalls();
        int bodies = random.nextInt(fewest, most + 1);
        while (bodies > 0) {
            bodies -= addBody();
        }
        int lamps = random.nextInt(1, 4);
        for (int i = 0; i < lamps; i++) {
            lights.add(light(lamps));
        }
        Camera camera = camera();
        Settings settings = new Settings(color(0, random.nextDouble(0.1, 1)),
            random.nextInt(2, LARGEST_SHADOW_RAY_ROOT + 1), random.nextInt(2, 7), 1);
        return new Scene(camera, settings, materials, surfaces, lights);
    }

    private boolean isOnceIn(int times) {
        return random.nextInt(times) == 0;
    }

    /** Small values are as likely as large ones, on the scale of factors. */
    private double size(double least, double most) {
        return least * StrictMath.pow(most / least, random.nextDouble());
    }

    private Color color(double least, double most) {
        return new Color(between(least, most), between(least, most), between(least, most));
    }

    private double between(double least, double most) {
        return least + (most - least) * random.nextDouble();
    }

    /** Every fifth is a mirror, every fifth glass; half of the highlights are sharp. */
    private Material material() {
        boolean isMirror = isOnceIn(5);
        boolean isGlass = isOnceIn(5);
        Color specular = isOnceIn(3) ? Color.BLACK : color(0.2, 1);
        double exponent = random.nextBoolean() ? size(2, 50) : size(50, 2000);
        Color reflection = isMirror ? color(0.2, 0.9) : isGlass && random.nextBoolean() ? color(0.05, 0.2) : Color.BLACK;
        return new Material(color(0.05, 1), specular, reflection, exponent, isGlass ? between(0.4, 0.95) : 0, Color.BLACK);
    }

    private int oneMaterial() {
        return random.nextInt(materials.size());
    }

    private int matte() {
        materials.add(new Material(color(0.3, 0.9), Color.BLACK, Color.BLACK, 1, 0, Color.BLACK));
        return materials.size() - 1;
    }

    private void addWalls() {
        surfaces.add(new Plane(new Vector(0, 1, 0), 0, isOnceIn(3) ? oneMaterial() : matte()));
        if (!isOnceIn(3)) {
            surfaces.add(new Plane(new Vector(between(-0.3, 0.3), 0, -1), -between(7, 12), matte()));
        }
        if (isOnceIn(3)) {
            surfaces.add(new Plane(new Vector(1, 0, 0), -between(7, 10), matte()));
        }
    }

    /** Returns how many it added. */
    private int addBody() {
        double half = isOnceIn(6) ? size(0.005, 0.1) : size(0.15, 1.6);
        double height = random.nextBoolean() ? half : half + between(0, 4);
        Vector centre = new Vector(between(-5, 5), height, between(-4, 6));
        int material = oneMaterial();
        surfaces.add(random.nextInt(5) < 3 ? new Sphere(centre, half, material) : new Box(centre, 2 * half, material));
        if (materials.get(material).transparency() > 0 && random.nextBoolean()) {
            surfaces.add(new Sphere(centre, between(0.2, 0.9) * half, oneMaterial()));
            return 2;
        }
        return 1;
    }

    private Light light(int lamps) {
        Vector position = new Vector(between(-9, 9), between(5, 14), between(-12, 4));
        return new Light(position, color(0.6 / lamps, 1.5 / lamps), isOnceIn(4) ? 0 : 1, isOnceIn(3) ? between(0.4, 1) : 1,
            isOnceIn(3) ? 0 : size(0.2, 4));
    }

    /** Every fifth looks through a fisheye. */
    private Camera camera() {
        Lens lens = isOnceIn(5) ? new Fisheye(between(-0.7, 0.9)) : new Pinhole();
        Vector eye = new Vector(between(-4, 4), between(1, 7), between(-13, -8));
        Vector aim = new Vector(between(-1, 1), between(0, 2), between(-1, 1));
        return new Camera(eye, aim, new Vector(between(-0.1, 0.1), 1, 0), 1, between(0.6, 1.6), lens);
    }
}
