package raytracing.shade;

import raytracing.ambient.AmbientLight;
import raytracing.ambient.AmbientLookup;
import raytracing.color.Color;
import raytracing.color.MutableColor;
import raytracing.math.CounterRandom;
import raytracing.math.UnitVector;
import raytracing.math.Vector;
import raytracing.scene.CameraRays;
import raytracing.scene.Light;
import raytracing.scene.Material;
import raytracing.scene.Scene;
import raytracing.shade.MirroredRayQueue.MirroredRay;
import raytracing.shadow.ShadowMethod;
import raytracing.shadow.SoftShadows;
import raytracing.surface.Hit;
import raytracing.surface.PointError;
import raytracing.trace.PreparedScene;
import raytracing.trace.RayQuery;

/**
 * The light that arrives along a ray: a function of scene, ray and random key, whatever rays were followed before. Not
 * thread-safe; all that it needs is made once, so that following rays does not allocate.
 *
 * <p>At each surface: colour = behind * transparency + (diffuse + specular + ambient) * (1 - transparency) + mirrored *
 * reflection. Written as a sum over all surfaces that contribute, each with the product of the factors on its way to
 * the eye as its weight, this needs no recursion: a ray goes straight on through transparent surfaces, and the rays that
 * mirrors send on wait in a {@link MirroredRayQueue}. Beyond the recursion limit a mirror shows the background; the
 * background also stands for all that has a negligible weight, and for the rays that are left in the queue; where these weigh
 * much together, {@link LeftOutLight} corrects that.
 */
public final class Shader {
    /** Four times the rounding of a plane's unit normal. */
    private static final double NORMAL_ERROR = 0x1p-49;

    /** Counter of the key for a surface's mirrored ray; its lights use the counters from 0 on. */
    private static final long MIRROR = -1;

    /** Counter of the number that decides whether a path goes on from a surface. */
    private static final long VERTEX = -2;

    /**
     * A fingerprint is the value of a polynomial at an odd number with its bits well mixed. Its coefficients are a 1, which
     * makes surface 0 count, then the numbers of the surfaces met, with a number that no surface has at the end of each ray.
     */
    private static final long FINGERPRINT_FACTOR = 0xd1342543de82ef95L;
    private static final long NOTHING_MET = 1;
    private static final long NO_RAY = 0;
    private static final int END_OF_RAY = -1;

    /** Stands for the share of a wide light that is seen in part, in the hash of shadows. */
    private static final double IN_PART = 0.5;

    private final Material[] materials;
    private final Light[] lights;
    private final double[] lightErrors;
    private final Color background;
    private final int maxReflections;
    private final double ambientScale;
    private final double negligibleWeight;
    private final Thoroughness thoroughness;
    private final LeftOutLight leftOut;
    private final RayQuery query;
    private final SoftShadows shadows;
    private final AmbientLookup ambientLight;
    private final VertexReservoir vertex;
    private final MirroredRayQueue mirroredRays = new MirroredRayQueue();

    /** The direction in which the surface just met mirrors the ray. */
    private final UnitVector mirrored = new UnitVector();

    private final MutableColor pixel = new MutableColor();
    private final MutableColor surfaceLight = new MutableColor();
    private final MutableColor weight = new MutableColor();
    private final MutableColor mirroredWeight = new MutableColor();
    private int surfacesMet;
    private long fingerprint;
    private long directFingerprint;
    private long shadowFingerprint;
    private boolean isMirrorSeen;
    private double highlightMargin;
    private long eyeRayCount;
    private long mirroredRayCount;
    private long leftOutCount;
    private long surfaceCount;
    private long shadedCount;

    /** A shader for pictures of a scene, whose surfaces are also given prepared. */
    public Shader(Scene scene, PreparedScene prepared, ShadowMethod shadowMethod, AmbientLight ambientLight) {
        this(scene, prepared, shadowMethod, ambientLight, Thoroughness.OF_A_PICTURE,
            new VertexReservoir(VertexReservoir.Scattering.NONE));
    }

    /**
     * A shader for estimates: without ambient light, with hard shadows, and less thorough about mirrors and glass. It offers
     * each point that a ray meets to the vertex.
     */
    public static Shader forEstimates(Scene scene, PreparedScene prepared, VertexReservoir vertex) {
        return new Shader(scene, prepared, ShadowMethod.Sampled.withRoot(1), AmbientLight.NONE,
            Thoroughness.OF_A_MEAN, vertex);
    }

    Shader(Scene scene, PreparedScene prepared, ShadowMethod shadowMethod, AmbientLight ambientLight,
           Thoroughness thoroughness, VertexReservoir vertex) {
        this.ambientLight = new AmbientLookup(ambientLight);
        this.vertex = vertex;
        this.thoroughness = thoroughness;
        negligibleWeight = thoroughness.negligibleWeight();
        ambientScale = scene.settings().ambientScale();
        materials = scene.materials().toArray(new Material[0]);
        lights = scene.lights().toArray(new Light[0]);
        lightErrors = new double[lights.length];
        for (int i = 0; i < lights.length; i++) {
            lightErrors[i] = PointError.written(lights[i].position());
        }
        background = scene.settings().background();
        maxReflections = scene.settings().maxReflections();
        leftOut = new LeftOutLight(background, maxReflections, thoroughness.unseenWeight());
        query = new RayQuery(prepared);
        shadows = shadowMethod.shadows(prepared, scene.settings().shadowRayRoot(), lights.length);
    }

    /**
     * The light that the eye sees at a point of the picture.
     *
     * @param key of all random numbers on the way; the same key gives the same light
     * @return linear light, not clamped; overwritten by the next call
     */
    public MutableColor light(CameraRays rays, double x, double y, long key) {
        pixel.clear();
        fingerprint = NO_RAY;
        directFingerprint = NO_RAY;
        shadowFingerprint = NO_RAY;
        isMirrorSeen = false;
        highlightMargin = Double.POSITIVE_INFINITY;
        if (rays.start(x, y, query.ray())) {
            query.begin();
            followAll(key);
        }
        return pixel;
    }

    /** In the same way, the light that arrives at a hit from a unit direction, on the side from which the hit was seen. */
    public MutableColor light(Hit hit, double dx, double dy, double dz, long key) {
        pixel.clear();
        query.start(hit.origin(), dx, dy, dz);
        followAll(key);
        return pixel;
    }

    /**
     * A hash of the surfaces that the rays of the last {@link #light} met in this order, in mirrors and behind glass too: two
     * different lists have the same one with a chance of about 1 in 2^64. It is 0 where the lens shows black.
     */
    public long fingerprint() {
        return fingerprint;
    }

    /** The same hash of the surfaces that the ray itself met, without the mirrored rays. */
    public long directFingerprint() {
        return directFingerprint;
    }

    /** A hash of which lights reached the points that the last rays met: wholly, not at all, or in part. */
    public long shadowFingerprint() {
        return shadowFingerprint;
    }

    /** Whether the last ray led to mirrored rays. */
    public boolean isMirrorSeen() {
        return isMirrorSeen;
    }

    /** The least {@link Phong#sharpMargin} at all points that the last rays met; infinite where no highlight is sharp. */
    public double highlightMargin() {
        return highlightMargin;
    }

    /** Forgets earlier rays, on which the number of shadow rays may depend, but never the light. */
    public void forgetPast() {
        shadows.forgetPast();
    }

    /** What all calls of {@link #light} so far took together. */
    public RayCounts counts() {
        return new RayCounts(eyeRayCount, mirroredRayCount, leftOutCount, surfaceCount, shadedCount * lights.length,
            shadows.queries(), shadows.settled(), shadows.rays(), shadows.areas());
    }

    /** Follows the ray of the query that was started, then the mirrored rays, the heaviest first. */
    private void followAll(long key) {
        eyeRayCount++;
        mirroredRays.clear();
        leftOut.clear();
        vertex.clear();
        surfacesMet = 0;
        fingerprint = NOTHING_MET;
        weight.set(1, 1, 1);
        follow(0, key);
        addToFingerprint(END_OF_RAY);
        directFingerprint = fingerprint;
        isMirrorSeen = !mirroredRays.isEmpty();
        int most = surfacesMet + thoroughness.mostSurfaces();
        int raysLeft = thoroughness.mostRays();
        while (surfacesMet < most && raysLeft > 0 && !mirroredRays.isEmpty()) {
            mirroredRayCount++;
            raysLeft--;
            MirroredRay next = mirroredRays.remove();
            leftOut.follow(next.weight, pixel);
            query.start(next.ray.origin(), next.ray.dx(), next.ray.dy(), next.ray.dz());
            weight.set(next.weight);
            follow(next.reflections, next.key);
            addToFingerprint(END_OF_RAY);
        }
        surfaceCount += surfacesMet;
        leaveOutTheRest();
    }

    /** Takes the background for the rays that still wait, and corrects it where they weigh much. */
    private void leaveOutTheRest() {
        leftOut.end(pixel);
        if (!mirroredRays.isEmpty()) {
            for (MirroredRay waiting : mirroredRays.waiting()) {     // sorting them by weight would double the pixel's time
                leftOutCount++;
                leftOut.leaveWaiting(waiting.weight, waiting.reflections);
                pixel.add(1, waiting.weight, background);
            }
        }
        leftOut.addTo(pixel);
    }

    private void addToFingerprint(int number) {
        fingerprint = FINGERPRINT_FACTOR * fingerprint + number;
    }

    /**
     * Adds what one ray sees to the pixel: the surfaces along it up to the first opaque one, or else the background. This and
     * {@link #addDirectLight} are long so that they are not compiled again into each of their callers (LongMethodsTest).
     */
    private void follow(int reflections, long key) {
        Hit hit = query.hit();
        double dx = query.ray().dx();
        double dy = query.ray().dy();
        double dz = query.ray().dz();
        int passed = 0;
        while (query.advance()) {
            surfacesMet++;
            addToFingerprint(query.surface());
            Material material = materials[query.material()];
            double transparency = material.transparency();
            long hitKey = CounterRandom.bits(key, passed++);
            double twice = -2 * hit.alongNormal(dx, dy, dz);
            mirrored.set(dx + twice * hit.normalX(), dy + twice * hit.normalY(), dz + twice * hit.normalZ());
            if (transparency < 1) {
                surfaceLight.clear();
                addDirectLight(material, hitKey);
                if (ambientLight.hasLight() && !material.ambient().isBlack()) {
                    surfaceLight.add(ambientScale, material.ambient(), ambientLight.at(hit));
                }
                if (vertex.isActive()) {
                    vertex.offer(hit, material, weight, CounterRandom.bits(hitKey, VERTEX));
                }
                pixel.add(1 - transparency, weight, surfaceLight);
            }
            if (!material.reflection().isBlack()) {
                mirroredWeight.setProduct(weight, material.reflection());
                leftOut.goOn(mirroredWeight);
                if (reflections < maxReflections && mirroredWeight.max() >= negligibleWeight) {
                    mirroredRays.add(hit.origin(), mirrored, mirroredWeight, reflections + 1,
                        CounterRandom.bits(hitKey, MIRROR));
                } else {
                    leaveOut(reflections);
                }
            }
            if (transparency == 0) {
                return;
            }
            weight.scale(transparency);
            if (weight.max() < negligibleWeight) {
                leftOut.goOn(weight);
                leftOut.leaveOut(weight, reflections);
                break;                       // the background stands for all that is behind
            }
        }
        pixel.add(1, weight, background);
    }

    /** Takes the background for a mirrored ray that is too faint, or beyond the limit of mirroring. */
    private void leaveOut(int reflections) {
        if (reflections < maxReflections) {
            leftOutCount++;
            leftOut.leaveOut(mirroredWeight, reflections + 1);
        } else {
            leftOut.replace(mirroredWeight);
        }
        pixel.add(1, mirroredWeight, background);
    }

    /**
     * Adds diffuse and specular light of all lamps that reach this side of the surface: the sum of
     * share * light * (Kd (N.L) + Ks intensity max(0, R.V)^n) over the lights that the surface faces.
     *
     * <p>A light no higher above a surface than the errors of both points and of the unit normal counts as in the surface and
     * does not shine on it. Nor does one that is further away than any double.
     */
    private void addDirectLight(Material material, long hitKey) {
        shadedCount++;
        Hit hit = query.hit();
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
            // false also if the height is NaN, as of a light too far away
            if (!(height > heightError && height < Double.POSITIVE_INFINITY)) {
                continue;
            }
            double highlight = 0;
            if (!isMatte) {
                double cosine = mirrored.dot(x, y, z) / distance;
                highlight = Phong.highlight(light.specularIntensity(), cosine, material.phongExponent());
                highlightMargin = Math.min(highlightMargin, Phong.sharpMargin(cosine, material.phongExponent()));
            }
            if (highlight > 0 || !diffuse.isBlack()) {
                double share = shadows.arrivingShare(hit, light, i, lightErrors[i], CounterRandom.bits(hitKey, i));
                surfaceLight.add(share * (height / distance), diffuse, light.color());
                surfaceLight.add(share * highlight, specular, light.color());
                double state = share == 1 || share == 1 - light.shadowIntensity() || shadows.isHard(light) ? share : IN_PART;
                shadowFingerprint = FINGERPRINT_FACTOR * shadowFingerprint + Double.doubleToRawLongBits(state);
            }
        }
    }
}
