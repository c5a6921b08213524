package raytracing.shade;

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
 * <p>At each surface: colour = behind * transparency + (diffuse + specular + ambient) * (1 - transparency) + mirrored *
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

    /**
     * Surfaces that the rays of one pixel may meet before those that still wait are left out. Ten times as many as the
     * deepest scene that we know needs (a nest of transparent balls, 373; {@code scenes/bubbles.txt}, 97), and few enough
     * that a pixel never takes longer than about a millisecond without lights.
     */
    static final int MOST_SURFACES = 1 << 12;

    /**
     * The same for the rays of an estimate, thousands of which make a mean: what one of them leaves out adds at most a
     * sixty-fourth of its light, and in a hall of mirrors it ends sooner.
     */
    private static final double NEGLIGIBLE_IN_A_MEAN = 0x1p-6;
    private static final int MOST_SURFACES_IN_A_MEAN = 1 << 7;

    /** Four times the rounding of a plane's unit normal. */
    private static final double NORMAL_ERROR = 0x1p-49;

    /** Counter of the key for a surface's mirrored ray; its lights use the counters from 0 on. */
    private static final long MIRROR = -1;

    /** Counter of the number that decides whether a path goes on from a surface. */
    private static final long VERTEX = -2;

    /**
     * A fingerprint is the value of a polynomial whose coefficients are the numbers of the surfaces met, a number that
     * no surface has for the end of each ray, and before all of them a 1, which makes surface 0 count. It is taken at
     * any odd number with its bits well mixed.
     */
    private static final long FINGERPRINT_FACTOR = 0xd1342543de82ef95L;
    private static final long NOTHING_MET = 1;
    private static final long NOTHING_ASKED = 0;
    private static final int END_OF_RAY = -1;

    private final Material[] materials;
    private final Light[] lights;
    private final double[] lightErrors;
    private final Color background;
    private final int maxReflections;
    private final double negligibleWeight;
    private final int mostSurfaces;
    private final RayWalk walk;
    private final SoftShadows shadows;
    private final Branches branches = new Branches();
    private final LightSum pixel = new LightSum();
    private final LightSum direct = new LightSum();
    private final AmbientLookup ambientLight;
    private final double ambientScale;
    private final PathVertex vertex;
    private final Weight weight = new Weight();
    private final Weight mirrorWeight = new Weight();
    private int surfacesMet;
    private long eyeRays;
    private long mirroredRays;
    private long mirroredLeftOut;
    private long allSurfacesMet;
    private long pointsShaded;
    private long fingerprint;
    private double mirroredX;
    private double mirroredY;
    private double mirroredZ;

    /**
     * Prepares the shading of a scene.
     *
     * @param scene materials, lights and settings
     * @param compiled the same scene's surfaces
     * @param shadowMethod how soft shadows are found
     * @param ambientLight of the room
     */
    public Shader(Scene scene, CompiledScene compiled, ShadowMethod shadowMethod, AmbientLight ambientLight) {
        this(scene, compiled, shadowMethod, ambientLight, NEGLIGIBLE_WEIGHT);
    }

    /** With another weight below which light is not followed: 0 follows all of it. */
    Shader(Scene scene, CompiledScene compiled, ShadowMethod shadowMethod, AmbientLight ambientLight,
           double negligibleWeight) {
        this(scene, compiled, shadowMethod, ambientLight, negligibleWeight, MOST_SURFACES,
            new PathVertex(PathVertex.Scattering.NONE));
    }

    private Shader(Scene scene, CompiledScene compiled, ShadowMethod shadowMethod, AmbientLight ambientLight,
                   double negligibleWeight, int mostSurfaces, PathVertex vertex) {
        this.ambientLight = new AmbientLookup(ambientLight);
        this.vertex = vertex;
        ambientScale = scene.settings().ambientScale();
        this.negligibleWeight = negligibleWeight;
        this.mostSurfaces = mostSurfaces;
        materials = scene.materials().toArray(new Material[0]);
        lights = scene.lights().toArray(new Light[0]);
        lightErrors = new double[lights.length];
        for (int i = 0; i < lights.length; i++) {
            lightErrors[i] = PointError.written(lights[i].position());
        }
        background = scene.settings().background();
        maxReflections = scene.settings().maxReflections();
        walk = new RayWalk(compiled);
        shadows = SoftShadows.of(compiled, shadowMethod, scene.settings().shadowRayRoot(), lights.length);
    }

    /**
     * A shader for estimates: without ambient light, with hard shadows, and less thorough about mirrors and glass.
     *
     * @param scene materials, lights and settings
     * @param compiled the same scene's surfaces
     * @param vertex is offered whatever a ray meets
     */
    static Shader forEstimates(Scene scene, CompiledScene compiled, PathVertex vertex) {
        return new Shader(scene, compiled, ShadowMethod.Sampled.withRoot(1), AmbientLight.NONE, NEGLIGIBLE_IN_A_MEAN,
            MOST_SURFACES_IN_A_MEAN, vertex);
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
        fingerprint = NOTHING_ASKED;
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

    /**
     * What arrives at a hit from a direction on the side from which it was seen.
     *
     * @param from the hit
     * @param dx unit direction, x part
     * @param dy y part
     * @param dz z part
     * @param key of all random numbers on the way
     * @return linear light, not clamped; overwritten by the next
     */
    LightSum light(HitPoint from, double dx, double dy, double dz, long key) {
        pixel.clear();
        walk.start(from.place(), dx, dy, dz);
        followAll(key);
        return pixel;
    }

    /**
     * What was seen, mirrored and through transparent surfaces too, in one number: two rays of the eye that met the
     * same surfaces in the same order have the same one, others have others but for a chance of about 1 in 2^64.
     *
     * @return a hash of the surfaces that the rays of the last {@link #light} met; 0 where the lens shows black
     */
    public long fingerprint() {
        return fingerprint;
    }

    /**
     * Forgets the rays before. The light never depends on them, but what it takes to find it may: after this, what a piece
     * of work takes is the same whatever was done before it.
     */
    public void forgetPast() {
        shadows.forgetPast();
    }

    /**
     * What all calls of {@link #light} so far took together.
     *
     * @return numbers of rays by kind
     */
    public RayCounts counts() {
        return new RayCounts(eyeRays, mirroredRays, mirroredLeftOut, allSurfacesMet, pointsShaded * lights.length,
            shadows.asked(), shadows.settled(), shadows.rays(), shadows.areas());
    }

    private void followAll(long key) {
        eyeRays++;
        branches.clear();
        vertex.clear();
        surfacesMet = 0;
        fingerprint = NOTHING_MET;
        weight.set(1, 1, 1);
        int reflections = 0;
        long rayKey = key;
        boolean goesOn = true;
        while (goesOn) {
            follow(reflections, rayKey);
            fingerprint = FINGERPRINT_FACTOR * fingerprint + END_OF_RAY;
            goesOn = surfacesMet < mostSurfaces && branches.next();
            if (goesOn) {
                mirroredRays++;
                branches.start(walk);
                branches.weigh(weight);
                reflections = branches.reflections();
                rayKey = branches.key();
            }
        }
        allSurfacesMet += surfacesMet;
        while (branches.next()) {
            mirroredLeftOut++;
            branches.weigh(weight);
            pixel.add(1, weight, background);
        }
    }

    /**
     * What one straight ray adds to the pixel: the surfaces along it up to the first opaque one, then the background. This
     * and {@link #addDirectLight} are long on purpose: the virtual machine does not compile a method of more than 325 bytes
     * into its callers again (DECISIONS).
     */
    private void follow(int reflections, long key) {
        HitPoint hit = walk.point();
        double dx = walk.directionX();
        double dy = walk.directionY();
        double dz = walk.directionZ();
        int passed = 0;
        while (walk.advance()) {
            surfacesMet++;
            fingerprint = FINGERPRINT_FACTOR * fingerprint + walk.surface();
            Material material = materials[walk.material()];
            double transparency = material.transparency();
            long hitKey = CounterRandom.bits(key, passed++);
            // the unit direction in which a mirror sends on what comes along the ray
            double twice = -2 * (dx * hit.normalX() + dy * hit.normalY() + dz * hit.normalZ());
            double x = dx + twice * hit.normalX();
            double y = dy + twice * hit.normalY();
            double z = dz + twice * hit.normalZ();
            double scale = Vector.safeScale(x, y, z);
            double factor = Vector.unitFactor(scale * x, scale * y, scale * z);
            mirroredX = scale * x * factor;
            mirroredY = scale * y * factor;
            mirroredZ = scale * z * factor;
            if (transparency < 1) {
                addDirectLight(material, hitKey);
                addAmbientLight(material);
                if (vertex.isWanted()) {
                    vertex.offer(hit, material, weight, CounterRandom.bits(hitKey, VERTEX));
                }
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

    /** Whatever of the room's light is not a lamp's. */
    private void addAmbientLight(Material material) {
        if (ambientLight.isWanted() && !material.ambient().isBlack()) {
            direct.add(ambientScale, material.ambient(), ambientLight.at(walk.point()));
        }
    }

    private void sendMirrored(Color reflection, int reflections, long hitKey) {
        mirrorWeight.setFiltered(weight, reflection);
        if (reflections == maxReflections) {
            pixel.add(1, mirrorWeight, background);
        } else if (mirrorWeight.max() < negligibleWeight) {
            mirroredLeftOut++;
            pixel.add(1, mirrorWeight, background);
        } else {
            branches.add(walk.point().place(), mirroredX, mirroredY, mirroredZ, mirrorWeight, reflections + 1,
                CounterRandom.bits(hitKey, MIRROR));
        }
    }

    /**
     * Sums diffuse and specular light of all lamps that reach this side of the surface: the sum of
     * share * light * (Kd (N.L) + Ks intensity max(0, R.V)^n) over the lights that the surface faces.
     *
     * <p>A light no higher above a surface than the errors of both points along a unit normal, and that of the normal
     * itself, is in the surface, as far as doubles know, and does not shine on it. Nor does one that is further away than
     * any double.
     */
    private void addDirectLight(Material material, long hitKey) {
        direct.clear();
        pointsShaded++;
        HitPoint hit = walk.point();
        double normalX = hit.normalX();
        double normalY = hit.normalY();
        double normalZ = hit.normalZ();
        Color diffuse = material.diffuse();
        Color specular = material.specular();
        boolean isMatte = specular.isBlack();
        for (int i = 0; i < lights.length; i++) {
            Light light = lights[i];
            double x = light.position().x() - hit.x();
            double y = light.position().y() - hit.y();
            double z = light.position().z() - hit.z();
            double distance = Vector.length(x, y, z);
            double height = normalX * x + normalY * y + normalZ * z;
            double heightError = 2 * (hit.error() + lightErrors[i]) + NORMAL_ERROR * distance;
            // this way round, also where the light itself is, or where its height is beyond all doubles
            if (!(height > heightError && height < Double.POSITIVE_INFINITY)) {
                continue;
            }
            double highlight = 0;
            if (!isMatte) {
                double cosine = (mirroredX * x + mirroredY * y + mirroredZ * z) / distance;
                highlight = Phong.highlight(light.specularIntensity(), cosine, material.phongExponent());
            }
            if (highlight > 0 || !diffuse.isBlack()) {
                double share = shadows.arrivingShare(hit, light, i, lightErrors[i],
                    CounterRandom.bits(hitKey, i));
                direct.add(share * (height / distance), diffuse, light.color());
                direct.add(share * highlight, specular, light.color());
            }
        }
    }
}
