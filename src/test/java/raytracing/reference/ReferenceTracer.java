package raytracing.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import raytracing.color.Color;
import raytracing.color.MutableColor;
import raytracing.film.Film;
import raytracing.math.Basis;
import raytracing.math.CounterRandom;
import raytracing.math.Powers;
import raytracing.math.Vector;
import raytracing.scene.CameraRays;
import raytracing.scene.Light;
import raytracing.scene.Material;
import raytracing.scene.Scene;
import raytracing.surface.Body;
import raytracing.surface.Box;
import raytracing.surface.Departure;
import raytracing.surface.Hit;
import raytracing.surface.PointError;
import raytracing.surface.Ray;
import raytracing.surface.Segment;
import raytracing.surface.Surface;

/**
 * The whole ray tracer without anything that makes it fast: every ray tests every surface of the scene, and a mirror calls the
 * tracer again. Read this first. The program draws the same pictures, as {@code ReferenceTracerTest} checks.
 *
 * <p>Where a ray meets a surface, it sees
 * {@code behind * transparency + (diffuse + specular) * (1 - transparency) + mirrored * reflection}. It sees the background
 * where it meets none, where it was mirrored too often, and where its light is too weak to be shown. Ambient light is left
 * out: {@code BruteForceLight} checks that.
 *
 * <p>This shares with the program the rays of the camera, the random numbers, and what a single surface knows about a ray or
 * a segment. It has no hierarchy, no lists of surfaces by kind, no shafts of shadow rays, no queue of mirrored rays, and no
 * rules for lengths near the ends of the range of doubles.
 */
public final class ReferenceTracer {
    /** Light of 1 with a smaller weight adds less than a sixteenth of a step of 1/255 to a pixel. */
    private static final double NEGLIGIBLE_WEIGHT = 0x1p-12;

    /** Distances with a smaller relative difference do not tell which of two crossings comes first. */
    private static final double CLOSE = 0x1p-43;

    /** By how much a unit normal may be off. */
    private static final double NORMAL_ERROR = 0x1p-49;

    /** A mirrored ray has this random number of the hit as its key; the lights have those from 0 on. */
    private static final long MIRROR = -1;

    private final Scene scene;
    private final List<Surface> surfaces;
    private final int width;
    private final int height;
    private final long seed;
    private final CameraRays cameraRays;

    /** A surface that a ray meets, and the distance to its first crossing, in multiples of the ray's direction. */
    private record Crossing(int number, double distance) {
    }

    /** Prepares a picture of this size in pixels; with another seed it has other random numbers. */
    public ReferenceTracer(Scene scene, int width, int height, long seed) {
        this.scene = scene;
        this.width = width;
        this.height = height;
        this.seed = seed;
        surfaces = scene.surfaces();
        cameraRays = new CameraRays(scene.camera(), width, height);
    }

    /** Draws the picture. Pixels do not depend on each other. */
    public Film draw() {
        Film film = new Film(width, height);
        IntStream.range(0, width * height).parallel().forEach(i -> {
            MutableColor light = pixel(i % width, i / width);
            film.set(i % width, i / width, light.red(), light.green(), light.blue());
        });
        return film;
    }

    /** The light of the ray through the centre of a pixel; black where the lens shows nothing. */
    private MutableColor pixel(int x, int y) {
        Ray ray = new Ray();
        MutableColor light = new MutableColor();
        MutableColor weight = new MutableColor();
        weight.set(1, 1, 1);
        if (cameraRays.start(x + 0.5, y + 0.5, ray)) {
            addLight(ray, weight, 0, CounterRandom.bits(CounterRandom.bits(seed, x), y), light);
        }
        return light;
    }

    /**
     * Adds what a ray sees to the light of the pixel.
     *
     * @param weight factor on it, which every surface that the ray passes makes smaller
     * @param reflections between this ray and the camera
     * @param key of all random numbers along the ray
     */
    private void addLight(Ray ray, MutableColor weight, int reflections, long key, MutableColor pixel) {
        List<Crossing> crossings = reflections > scene.settings().maxReflections() ? List.of() : crossings(ray);
        for (int i = 0; i < crossings.size() && weight.max() >= NEGLIGIBLE_WEIGHT; i++) {
            Hit hit = hit(ray, crossings.get(i));
            Material material = scene.materials().get(surfaces.get(hit.surface()).material());
            Vector mirrored = mirrored(ray, hit);
            long hitKey = CounterRandom.bits(key, i);
            pixel.add(1 - material.transparency(), weight, direct(hit, material, mirrored, hitKey));
            if (!material.reflection().isBlack()) {
                Ray mirroredRay = new Ray();
                mirroredRay.leave(hit.origin(), mirrored.x(), mirrored.y(), mirrored.z());
                MutableColor mirroredWeight = new MutableColor();
                mirroredWeight.setProduct(weight, material.reflection());
                addLight(mirroredRay, mirroredWeight, reflections + 1, CounterRandom.bits(hitKey, MIRROR), pixel);
            }
            weight.scale(material.transparency());
        }
        pixel.add(1, weight, scene.settings().background());
    }

    /**
     * The surfaces along a ray, each with its first crossing, from the nearest on. Surfaces at the same distance are in the
     * order of the scene.
     */
    private List<Crossing> crossings(Ray ray) {
        List<Crossing> crossings = new ArrayList<>();
        for (int number = 0; number < surfaces.size(); number++) {
            double distance = firstCrossing(ray, number);
            if (distance < Surface.MISS) {
                crossings.add(new Crossing(number, distance));
            }
        }
        crossings.sort((a, b) -> order(ray, a, b));
        return crossings;
    }

    /** A ray that starts on a surface meets it again only if it goes into the body: on the opposite wall. */
    private double firstCrossing(Ray ray, int number) {
        Surface surface = surfaces.get(number);
        double distance = ray.origin().surface() != number ? surface.firstCrossing(ray, Surface.MISS)
            : ray.origin().side() == Departure.INWARD && surface instanceof Body body ? body.farWall(ray) : Surface.MISS;
        return Double.isNaN(distance) ? Surface.distance(surface.exactCrossing(ray, number)) : distance;
    }

    /** Below 0 if a comes before b: by the distances in doubles if these are clearly different, else by the exact ones. */
    private int order(Ray ray, Crossing a, Crossing b) {
        if (Math.abs(a.distance - b.distance) > CLOSE * Math.max(a.distance, b.distance)) {
            return Double.compare(a.distance, b.distance);
        }
        return surfaces.get(a.number).exactCrossing(ray, a.number).orElseThrow()
            .compareTo(surfaces.get(b.number).exactCrossing(ray, b.number).orElseThrow());
    }

    /**
     * Point and normal of a crossing. On an edge of a box, the face is one that continues a face of another box, if there is
     * one: so a wall of boxes is even.
     */
    private Hit hit(Ray ray, Crossing crossing) {
        Hit hit = new Hit();
        Surface surface = surfaces.get(crossing.number);
        surface.describe(ray, crossing.number, crossing.distance, hit);
        if (surface instanceof Box box && hit.side() == Departure.OUTWARD
                && Integer.bitCount(box.facesEntered(hit.origin(), ray)) > 1) {
            int faces = box.facesEntered(hit.origin(), ray);
            for (Surface other : surfaces) {
                int shared = other instanceof Box neighbour ? faces & neighbour.facesEntered(hit.origin(), ray) : 0;
                faces = shared == 0 ? faces : shared;
            }
            box.describeOnFaces(faces, ray, crossing.number, crossing.distance, hit);
        }
        return hit;
    }

    /** The direction of a ray behind a mirror, of length 1. */
    private static Vector mirrored(Ray ray, Hit hit) {
        double twice = -2 * hit.alongNormal(ray.dx(), ray.dy(), ray.dz());
        return new Vector(ray.dx() + twice * hit.normalX(), ray.dy() + twice * hit.normalY(),
            ray.dz() + twice * hit.normalZ()).unit();
    }

    /**
     * Diffuse light and highlights after Phong: for each light before the surface, in direction L, the share that arrives
     * times {@code diffuse (N.L) + specular (R.L)^n}, with R the mirrored direction of the ray. A light that may lie in the
     * surface, within the errors of both points, does not shine on it.
     */
    private MutableColor direct(Hit hit, Material material, Vector mirrored, long key) {
        MutableColor sum = new MutableColor();
        for (int i = 0; i < scene.lights().size(); i++) {
            Light light = scene.lights().get(i);
            Vector way = light.position().minus(new Vector(hit.x(), hit.y(), hit.z()));
            double distance = way.length();
            double height = hit.alongNormal(way.x(), way.y(), way.z());
            double error = PointError.written(light.position());
            if (height > 2 * (hit.error() + error) + NORMAL_ERROR * distance) {
                double arriving = arrivingShare(hit, light, way, error, CounterRandom.bits(key, i));
                double cosine = Math.max(0, Math.min(mirrored.dot(way) / distance, 1));
                double highlight = light.specularIntensity() * Powers.power(cosine, material.phongExponent());
                sum.add(arriving * (height / distance), material.diffuse(), light.color());
                sum.add(arriving * highlight, material.specular(), light.color());
            }
        }
        return sum;
    }

    /**
     * The share of a light that arrives at a hit: the mean of N x N shadow rays. Each goes to a random point of its cell of
     * the light's square, which faces the hit; a single one goes to the middle.
     */
    private double arrivingShare(Hit hit, Light light, Vector way, double error, long key) {
        int root = light.width() == 0 ? 1 : scene.settings().shadowRayRoot();
        double cell = root == 1 ? 0 : light.width() / root;
        Vector middle = light.position();
        Basis square = new Basis();
        square.turnTo(way.x(), way.y(), way.z());
        double sum = 0;
        for (int i = 0; i < root * root; i++) {
            long bits = CounterRandom.bits(key, i);
            double x = (i % root + CounterRandom.upperFraction(bits) - root / 2.0) * cell;
            double y = (i / root + CounterRandom.lowerFraction(bits) - root / 2.0) * cell;
            Segment shadowRay = new Segment();
            shadowRay.connect(hit.origin(), middle.x() + (x * square.ux() + y * square.vx()),
                middle.y() + (x * square.uy() + y * square.vy()), middle.z() + (x * square.uz() + y * square.vz()), error);
            sum += transmittance(hit, shadowRay);
        }
        double intensity = light.shadowIntensity();
        return (1 - intensity) + intensity * (sum / (root * root));
    }

    /** What the surfaces between a hit and the end of a shadow ray let through: the product of their transparencies. */
    private double transmittance(Hit hit, Segment shadowRay) {
        double product = 1;
        for (int number = 0; number < surfaces.size(); number++) {
            if (isCrossed(number, hit, shadowRay)) {
                product *= scene.materials().get(surfaces.get(number).material()).transparency();
            }
        }
        return product;
    }

    /** The surface of the hit itself is crossed if the shadow ray goes into its body and out again. */
    private boolean isCrossed(int number, Hit hit, Segment shadowRay) {
        Surface surface = surfaces.get(number);
        if (number != hit.surface()) {
            return surface.isCrossed(shadowRay, number);
        }
        boolean goesInwards = hit.side() == Departure.INWARD
            || hit.departureTowards(shadowRay.dx(), shadowRay.dy(), shadowRay.dz()) == Departure.INWARD;
        return goesInwards && surface instanceof Body body && body.isLeft(shadowRay);
    }
}
