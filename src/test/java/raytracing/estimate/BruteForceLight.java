package raytracing.estimate;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import raytracing.color.Color;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.scene.Light;
import raytracing.scene.Material;
import raytracing.scene.Scene;
import raytracing.surface.Departure;
import raytracing.surface.HitRecord;
import raytracing.surface.PointError;
import raytracing.surface.RayRecord;
import raytracing.surface.SegmentRecord;
import raytracing.surface.Surface;
import raytracing.surface.SurfaceQuestions;

/**
 * Light in a scene by path tracing (Kajiya, The Rendering Equation, SIGGRAPH 1986), as literally as possible: it shares
 * the crossings of surfaces with the program and nothing else. Diffuse surfaces send on what arrives from everywhere,
 * by their diffuse colour, at most {@value #MOST_REFLECTANCE} of it. Not thread-safe.
 */
public final class BruteForceLight {
    /** Of the light that arrives evenly, no surface sends on more. */
    private static final double MOST_REFLECTANCE = 0.9;

    private final Scene scene;
    private final int bounces;
    private final Random random;

    /**
     * @param scene all of it
     * @param bounces how often light may be scattered between a lamp or the background and the point in question, at
     *        least 1
     * @param seed of the random numbers
     */
    public BruteForceLight(Scene scene, int bounces, long seed) {
        this.scene = scene;
        this.bounces = bounces;
        random = new Random(seed);
    }

    /** Where a ray meets a surface. */
    private record Crossing(double distance, int surface) {
    }

    /**
     * Ambient light at a point: the mean, weighted with the cosine, of what arrives from all directions on the side from
     * which it was seen. Lamps themselves do not count, for they are not there to be met. The hemisphere is divided into
     * root x root parts of equal weight, each with one random direction.
     *
     * @param hit the point
     * @param root of the number of directions
     * @return red, green, blue
     */
    public double[] ambient(HitRecord hit, int root) {
        double[] sum = new double[3];
        for (int i = 0; i < root; i++) {
            for (int j = 0; j < root; j++) {
                Vector direction = direction(hit.normal(), (i + random.nextDouble()) / root,
                    2 * Math.PI * (j + random.nextDouble()) / root);
                add(sum, 1.0 / (root * root), arriving(hit.leaving(direction), bounces, 0));
            }
        }
        return sum;
    }

    private static Vector direction(Vector normal, double squaredSine, double angle) {
        Vector aside = perpendicular(normal);
        return Vectors.plus(Vectors.plus(normal.times(Math.sqrt(1 - squaredSine)),
            Math.sqrt(squaredSine) * Math.cos(angle), aside), Math.sqrt(squaredSine) * Math.sin(angle),
                normal.cross(aside)).unit();
    }

    /**
     * What the eye sees of ambient light, and of nothing else, along a ray: straight on through transparent surfaces, and
     * in mirrors.
     *
     * @param ray from the eye
     * @param root of the number of directions at each point
     * @return red, green, blue of the light that ambient colours add to the picture
     */
    public double[] ambientSeen(RayRecord ray, int root) {
        return ambientSeen(ray, root, 0);
    }

    private double[] ambientSeen(RayRecord ray, int root, int reflections) {
        double[] seen = new double[3];
        double weight = 1;
        for (Crossing crossing : crossings(ray)) {
            HitRecord hit = HitRecord.at(scene.surfaces().get(crossing.surface), ray, crossing.distance, crossing.surface);
            Material material = scene.materials().get(hit.material());
            if (material.transparency() < 1 && !material.ambient().isBlack()) {
                double[] ambient = ambient(hit, root);
                addFiltered(seen, weight * (1 - material.transparency()) * scene.settings().ambientScale(),
                    material.ambient(), ambient);
            }
            if (!material.reflection().isBlack() && reflections < scene.settings().maxReflections()) {
                addFiltered(seen, weight, material.reflection(),
                    ambientSeen(hit.leaving(mirrored(ray.direction(), hit.normal())), root, reflections + 1));
            }
            weight *= material.transparency();
            if (weight == 0) {
                break;
            }
        }
        return seen;
    }

    /** All light that comes along a ray, by up to so many scatterings. */
    private double[] arriving(RayRecord ray, int scatterings, int reflections) {
        double[] light = new double[3];
        double weight = 1;
        for (Crossing crossing : crossings(ray)) {
            HitRecord hit = HitRecord.at(scene.surfaces().get(crossing.surface), ray, crossing.distance, crossing.surface);
            Material material = scene.materials().get(hit.material());
            double opaque = weight * (1 - material.transparency());
            if (opaque > 0) {
                add(light, opaque, direct(hit, material, ray.direction()));
                Color reflectance = limited(material.diffuse());
                // Russian roulette: a path goes on with this chance, and counts for those that do not
                double chance = Math.max(reflectance.red(), Math.max(reflectance.green(), reflectance.blue()));
                if (scatterings > 1 && random.nextDouble() < chance) {
                    addFiltered(light, opaque / chance, reflectance,
                        arriving(hit.leaving(randomDirection(hit.normal())), scatterings - 1, 0));
                }
            }
            if (!material.reflection().isBlack()) {
                addFiltered(light, weight, material.reflection(), reflections == scene.settings().maxReflections()
                    ? parts(scene.settings().background())
                    : arriving(hit.leaving(mirrored(ray.direction(), hit.normal())), scatterings, reflections + 1));
            }
            weight *= material.transparency();
            if (weight == 0) {
                return light;
            }
        }
        add(light, weight, parts(scene.settings().background()));
        return light;
    }

    /** The first crossing with every surface, in order. */
    private List<Crossing> crossings(RayRecord ray) {
        List<Crossing> crossings = new ArrayList<>();
        for (int i = 0; i < scene.surfaces().size(); i++) {
            double distance = SurfaceQuestions.firstCrossing(scene.surfaces().get(i), ray,
                i == ray.surfaceLeft() ? ray.departure() : Departure.ELSEWHERE);
            if (distance < Surface.MISS) {
                crossings.add(new Crossing(distance, i));
            }
        }
        crossings.sort(Comparator.comparingDouble(Crossing::distance).thenComparingInt(Crossing::surface));
        return crossings;
    }

    /** Phong's light of all lamps, each from one random point of its square. */
    private double[] direct(HitRecord hit, Material material, Vector incident) {
        double[] sum = new double[3];
        for (Light light : scene.lights()) {
            Vector way = light.position().minus(hit.point());
            double height = way.dot(hit.normal());
            double lowest = 4 * (hit.pointError() + PointError.written(light.position()));
            if (height > lowest) {
                Vector towards = way.unit();
                double hidden = light.shadowIntensity() * (1 - transmittance(hit, light, towards));
                double share = 1 - hidden;
                double cosine = towards.dot(mirrored(incident, hit.normal()));
                double highlight = light.specularIntensity()
                    * Math.pow(Math.min(Math.max(cosine, 0), 1), material.phongExponent());
                addFiltered(sum, share * towards.dot(hit.normal()), material.diffuse(), parts(light.color()));
                addFiltered(sum, share * highlight, material.specular(), parts(light.color()));
            }
        }
        return sum;
    }

    private double transmittance(HitRecord hit, Light light, Vector towards) {
        Vector aside = perpendicular(towards);
        Vector end = Vectors.plus(Vectors.plus(light.position(), light.width() * (random.nextDouble() - 0.5), aside),
            light.width() * (random.nextDouble() - 0.5), towards.cross(aside));
        double product = 1;
        SegmentRecord segment = new SegmentRecord(hit.point(), hit.pointError(), end, PointError.written(end));
        Vector way = end.minus(hit.point());
        for (int i = 0; i < scene.surfaces().size(); i++) {
            Surface surface = scene.surfaces().get(i);
            Departure departure = i != hit.surface() ? Departure.ELSEWHERE
                : hit.side() == Departure.INWARD ? Departure.INWARD : hit.departureTowards(way.x(), way.y(), way.z());
            if (SurfaceQuestions.crosses(surface, segment, departure)) {
                product *= scene.materials().get(surface.material()).transparency();
            }
        }
        return product;
    }

    private static Vector mirrored(Vector incident, Vector normal) {
        return Vectors.plus(incident, -2 * incident.dot(normal), normal).unit();
    }

    /** Any direction, in proportion to its cosine. */
    private Vector randomDirection(Vector normal) {
        return direction(normal, random.nextDouble(), 2 * Math.PI * random.nextDouble());
    }

    private static Vector perpendicular(Vector direction) {
        Vector axis = Math.abs(direction.x()) < 0.6 ? new Vector(1, 0, 0) : new Vector(0, 1, 0);
        return direction.cross(axis).unit();
    }

    private static Color limited(Color color) {
        return new Color(Math.min(color.red(), MOST_REFLECTANCE), Math.min(color.green(), MOST_REFLECTANCE),
            Math.min(color.blue(), MOST_REFLECTANCE));
    }

    private static double[] parts(Color color) {
        return new double[] {color.red(), color.green(), color.blue()};
    }

    private static void add(double[] sum, double weight, double[] light) {
        for (int channel = 0; channel < sum.length; channel++) {
            sum[channel] += weight * light[channel];
        }
    }

    private static void addFiltered(double[] sum, double weight, Color filter, double[] light) {
        sum[0] += weight * filter.red() * light[0];
        sum[1] += weight * filter.green() * light[1];
        sum[2] += weight * filter.blue() * light[2];
    }
}
