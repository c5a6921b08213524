package raytracing.shade;

import java.util.List;
import java.util.Optional;
import raytracing.color.Color;
import raytracing.compiled.CompiledScene;
import raytracing.geometry.Hit;
import raytracing.geometry.PointError;
import raytracing.geometry.Ray;
import raytracing.math.CounterRandom;
import raytracing.math.Vector;
import raytracing.scene.Light;
import raytracing.scene.Material;
import raytracing.scene.Scene;
import raytracing.shade.Branches.Branch;

/**
 * The light that a ray of the eye brings back. A pure function of scene, ray and random key; thread-safe.
 *
 * <p>At each surface: colour = behind * transparency + (diffuse + specular) * (1 - transparency) + mirrored *
 * reflection. Written as a sum over all surfaces that contribute, each with the product of the factors on its way to
 * the eye as its weight, this needs no recursion: a ray goes straight on through transparent surfaces, and whatever
 * it sends aside into mirrors waits among the {@link Branches}. Beyond the recursion limit a mirror shows the
 * background; so does everything whose weight is negligible, and what the branches leave out.
 */
public final class Shader {
    /**
     * A weight that no 8-bit channel shows: light of 1 adds less than a sixteenth of a step of 1/255. This bounds what a
     * single ray left out can change (proved); many of them add up. On the scenes of this project no pixel differs by
     * more than one step from the picture with none left out (measured in {@code LeftOutLightTest}).
     */
    static final double NEGLIGIBLE_WEIGHT = 0x1p-12;

    /** Four times the rounding of a plane's unit normal. */
    private static final double NORMAL_ERROR = 0x1p-49;

    /** Counter of the key for a surface's mirrored ray; its lights use the counters from 0 on. */
    private static final long MIRROR = -1;

    private final CompiledScene compiled;
    private final List<Material> materials;
    private final List<Light> lights;
    private final Color background;
    private final int maxReflections;
    private final SoftShadows shadows;
    private final double negligibleWeight;

    /**
     * Prepares the shading of a scene.
     *
     * @param scene materials, lights and settings
     * @param compiled the same scene's surfaces
     */
    public Shader(Scene scene, CompiledScene compiled) {
        this(scene, compiled, NEGLIGIBLE_WEIGHT);
    }

    /** With another weight below which light is not followed: 0 follows all of it. */
    Shader(Scene scene, CompiledScene compiled, double negligibleWeight) {
        this.compiled = compiled;
        this.negligibleWeight = negligibleWeight;
        materials = scene.materials();
        lights = scene.lights();
        background = scene.settings().background();
        maxReflections = scene.settings().maxReflections();
        shadows = new SoftShadows(compiled, scene.settings().shadowRayRoot());
    }

    /**
     * What the eye sees along a ray.
     *
     * @param ray from the eye, unit direction
     * @param key of all random numbers on the way; the same key gives the same light
     * @return linear light, not clamped; each channel at least 0
     */
    public Color light(Ray ray, long key) {
        LightSum pixel = new LightSum();
        Branches branches = new Branches();
        follow(ray, Color.WHITE, 0, key, pixel, branches);
        for (Optional<Branch> next = branches.next(); next.isPresent(); next = branches.next()) {
            Branch branch = next.get();
            follow(branch.ray(), branch.weight(), branch.reflections(), branch.key(), pixel, branches);
        }
        for (Optional<Branch> left = branches.nextLeftOut(); left.isPresent(); left = branches.nextLeftOut()) {
            pixel.add(1, left.get().weight(), background);
        }
        return pixel.total();
    }

    /** What one straight ray adds to the pixel: the surfaces along it up to the first opaque one, then the background. */
    private void follow(Ray ray, Color rayWeight, int reflections, long key, LightSum pixel, Branches branches) {
        Color weight = rayWeight;
        int passed = 0;
        for (Optional<Hit> next = compiled.firstHit(ray); next.isPresent(); next = compiled.nextHit(ray, next.get())) {
            Hit hit = next.get();
            Material material = materials.get(hit.material());
            double transparency = material.transparency();
            long hitKey = CounterRandom.bits(key, passed++);
            Vector mirrored = Phong.mirrored(ray.direction(), hit.normal());
            if (transparency < 1) {
                pixel.add(1 - transparency, weight, directLight(material, hit, mirrored, hitKey));
            }
            if (!material.reflection().isBlack()) {
                Color mirrorWeight = weight.times(material.reflection());
                if (reflections == maxReflections || isNegligible(mirrorWeight)) {
                    pixel.add(1, mirrorWeight, background);
                } else {
                    long mirrorKey = CounterRandom.bits(hitKey, MIRROR);
                    branches.add(hit.leaving(mirrored), mirrorWeight, reflections + 1, mirrorKey);
                }
            }
            if (transparency == 0) {
                return;
            }
            weight = weight.times(transparency);
            if (isNegligible(weight)) {
                break;                       // the background stands for whatever is behind
            }
        }
        pixel.add(1, weight, background);
    }

    private boolean isNegligible(Color weight) {
        return weight.max() < negligibleWeight;
    }

    /**
     * Diffuse and specular light of all lamps that reach this side of the surface: the sum of
     * share * light * (Kd (N.L) + Ks intensity max(0, R.V)^n) over the lights that the surface faces.
     */
    private Color directLight(Material material, Hit hit, Vector mirrored, long hitKey) {
        LightSum sum = new LightSum();
        for (int i = 0; i < lights.size(); i++) {
            Light light = lights.get(i);
            Vector toLight = light.position().minus(hit.point());
            double distance = toLight.length();
            double height = hit.normal().dot(toLight);
            if (!(height > heightError(hit, light, distance))) {     // this way round, also where the light itself is
                continue;
            }
            double facing = height / distance;
            double highlight = Phong.highlight(material, light, mirrored.dot(toLight) / distance);
            if (highlight > 0 || !material.diffuse().isBlack()) {
                double share = shadows.arrivingShare(hit, light, CounterRandom.bits(hitKey, i));
                sum.add(share * facing, material.diffuse(), light.color());
                sum.add(share * highlight, material.specular(), light.color());
            }
        }
        return sum.total();
    }

    /**
     * A light no higher above a surface than this is in it, as far as doubles know, and does not shine on it: the errors
     * of both points along a unit normal, and that of the normal itself.
     */
    private static double heightError(Hit hit, Light light, double distance) {
        return 2 * (hit.pointError() + PointError.written(light.position())) + NORMAL_ERROR * distance;
    }
}
