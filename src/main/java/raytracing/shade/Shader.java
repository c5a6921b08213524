package raytracing.shade;

import java.util.List;
import raytracing.color.Color;
import raytracing.compiled.CompiledScene;
import raytracing.compiled.PixelRays;
import raytracing.compiled.RayWalk;
import raytracing.geometry.HitPoint;
import raytracing.geometry.PointError;
import raytracing.geometry.Ray;
import raytracing.math.CounterRandom;
import raytracing.math.Vector;
import raytracing.scene.Light;
import raytracing.scene.Material;
import raytracing.scene.Scene;

/**
 * The light that a ray of the eye brings back: a function of scene, ray and random key, whatever was asked before. One
 * thread; all that it needs is made once, so that rays make no garbage.
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

    private final List<Material> materials;
    private final List<Light> lights;
    private final Color background;
    private final int maxReflections;
    private final double negligibleWeight;
    private final RayWalk walk;
    private final SoftShadows shadows;
    private final Branches branches = new Branches();
    private final LightSum pixel = new LightSum();
    private final LightSum direct = new LightSum();
    private final Weight weight = new Weight();
    private final Weight mirrorWeight = new Weight();
    private double mirroredX;
    private double mirroredY;
    private double mirroredZ;

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
        this.negligibleWeight = negligibleWeight;
        materials = scene.materials();
        lights = scene.lights();
        background = scene.settings().background();
        maxReflections = scene.settings().maxReflections();
        walk = new RayWalk(compiled);
        shadows = new SoftShadows(compiled, scene.settings().shadowRayRoot());
    }

    /**
     * What the eye sees at a place of the picture.
     *
     * @param rays of the picture
     * @param x picture coordinate
     * @param y picture coordinate
     * @param key of all random numbers on the way; the same key gives the same light
     * @return linear light, not clamped; overwritten by the next
     */
    public LightSum light(PixelRays rays, double x, double y, long key) {
        pixel.clear();
        if (rays.start(x, y, walk)) {
            followAll(key);
        }
        return pixel;
    }

    /**
     * What the eye sees along a ray.
     *
     * @param ray from the eye, unit direction
     * @param key of all random numbers on the way; the same key gives the same light
     * @return linear light, not clamped; overwritten by the next
     */
    public LightSum light(Ray ray, long key) {
        pixel.clear();
        walk.start(ray);
        followAll(key);
        return pixel;
    }

    private void followAll(long key) {
        branches.clear();
        weight.set(1, 1, 1);
        follow(0, key);
        while (branches.next()) {
            branches.start(walk);
            branches.weigh(weight);
            follow(branches.reflections(), branches.key());
        }
        while (branches.nextLeftOut()) {
            branches.weigh(weight);
            pixel.add(1, weight, background);
        }
    }

    /** What one straight ray adds to the pixel: the surfaces along it up to the first opaque one, then the background. */
    private void follow(int reflections, long key) {
        int passed = 0;
        while (walk.advance()) {
            Material material = materials.get(walk.material());
            double transparency = material.transparency();
            long hitKey = CounterRandom.bits(key, passed++);
            mirror();
            if (transparency < 1) {
                addDirectLight(material, hitKey);
                pixel.add(1 - transparency, weight, direct);
            }
            if (!material.reflection().isBlack()) {
                sendMirrored(material.reflection(), reflections, hitKey);
            }
            if (transparency == 0) {
                return;
            }
            weight.scale(transparency);
            if (weight.max() < negligibleWeight) {
                break;                       // the background stands for whatever is behind
            }
        }
        pixel.add(1, weight, background);
    }

    private void sendMirrored(Color reflection, int reflections, long hitKey) {
        mirrorWeight.setFiltered(weight, reflection);
        if (reflections == maxReflections || mirrorWeight.max() < negligibleWeight) {
            pixel.add(1, mirrorWeight, background);
        } else {
            branches.add(walk.point(), walk.surface(), mirroredX, mirroredY, mirroredZ, mirrorWeight, reflections + 1,
                CounterRandom.bits(hitKey, MIRROR));
        }
    }

    /** Finds the unit direction in which a mirror at the hit sends on what comes along the walk's ray. */
    private void mirror() {
        HitPoint hit = walk.point();
        double twice = -2 * (walk.directionX() * hit.normalX() + walk.directionY() * hit.normalY()
            + walk.directionZ() * hit.normalZ());
        double x = walk.directionX() + twice * hit.normalX();
        double y = walk.directionY() + twice * hit.normalY();
        double z = walk.directionZ() + twice * hit.normalZ();
        double scale = Vector.safeScale(x, y, z);
        double factor = Vector.unitFactor(scale * x, scale * y, scale * z);
        mirroredX = scale * x * factor;
        mirroredY = scale * y * factor;
        mirroredZ = scale * z * factor;
    }

    /**
     * Sums diffuse and specular light of all lamps that reach this side of the surface: the sum of
     * share * light * (Kd (N.L) + Ks intensity max(0, R.V)^n) over the lights that the surface faces.
     */
    private void addDirectLight(Material material, long hitKey) {
        direct.clear();
        for (int i = 0; i < lights.size(); i++) {
            addLight(lights.get(i), material, CounterRandom.bits(hitKey, i));
        }
    }

    private void addLight(Light light, Material material, long key) {
        HitPoint hit = walk.point();
        double x = light.position().x() - hit.x();
        double y = light.position().y() - hit.y();
        double z = light.position().z() - hit.z();
        double distance = Vector.length(x, y, z);
        double height = hit.alongNormal(x, y, z);
        if (!(height > heightError(hit, light, distance))) {         // this way round, also where the light itself is
            return;
        }
        double facing = height / distance;
        double highlight = Phong.highlight(material, light, (mirroredX * x + mirroredY * y + mirroredZ * z) / distance);
        if (highlight > 0 || !material.diffuse().isBlack()) {
            double share = shadows.arrivingShare(hit, walk.surface(), light, key);
            direct.add(share * facing, material.diffuse(), light.color());
            direct.add(share * highlight, material.specular(), light.color());
        }
    }

    /**
     * A light no higher above a surface than this is in it, as far as doubles know, and does not shine on it: the errors
     * of both points along a unit normal, and that of the normal itself.
     */
    private static double heightError(HitPoint hit, Light light, double distance) {
        return 2 * (hit.error() + PointError.written(light.position())) + NORMAL_ERROR * distance;
    }
}
