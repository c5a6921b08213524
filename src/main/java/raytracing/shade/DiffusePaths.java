package raytracing.shade;

import raytracing.color.Color;
import raytracing.compiled.CompiledScene;
import raytracing.geometry.HitPoint;
import raytracing.math.Basis;
import raytracing.math.CounterRandom;
import raytracing.scene.Scene;

/**
 * Gathers the light that arrives at a place from everywhere but the lamps, by random paths from surface to surface (Kajiya,
 * The Rendering Equation, SIGGRAPH 1986). One thread, place after place.
 *
 * <p>Each ray brings what the picture would show along it, without ambient light and with hard shadows, and goes on from
 * one of the points that it met. Directions are drawn in proportion to their cosine: from points of the unit disc, lifted
 * to the hemisphere above it (Malley's method: Pharr, Jakob, Humphreys, Physically Based Rendering, section on
 * cosine-weighted hemisphere sampling). The first rays of a place go through a spiral that covers the disc evenly (Vogel,
 * A better way to construct the sunflower head, Mathematical Biosciences 44, 1979), turned by chance.
 */
final class DiffusePaths {
    /** Rays that leave each place (measured: DECISIONS). */
    static final int RAYS = 48;

    /** The light of so many bounces is each place's own; that of further ones differs little from place to place. */
    static final int OWN_BOUNCES = 2;

    /** Bounces that are followed; those beyond are summed up from the last one's (measured: DECISIONS). */
    static final int BOUNCES = 4;

    /** One in so many rays is followed further than the place's own bounces: their light is that of all places together. */
    private static final int RAYS_FOR_A_DEEP_ONE = 4;

    private static final double SHARE = 1.0 / RAYS;
    private static final double DEEP_SHARE = RAYS_FOR_A_DEEP_ONE * SHARE;

    /** Counters of a place's own random numbers; its rays have those from 0 on. */
    private static final long TURN = -1;
    private static final long DEEP = -2;

    private static final double[] SPIRAL = spiral();

    private final PathVertex vertex = new PathVertex(PathVertex.Scattering.DIFFUSE);
    private final Shader shader;
    private final HitPoint from = new HitPoint();
    private final Basis basis = new Basis();
    private final Weight path = new Weight();
    private double u;
    private double v;

    DiffusePaths(Scene scene, CompiledScene compiled) {
        shader = Shader.forEstimates(scene, compiled, vertex);
    }

    /** Directions in the disc, each the golden angle further than the one before. */
    private static double[] spiral() {
        double[] directions = new double[2 * RAYS];
        for (int i = 0; i < RAYS; i++) {
            double angle = i * Math.PI * (3 - Math.sqrt(5));
            directions[2 * i] = StrictMath.cos(angle);
            directions[2 * i + 1] = StrictMath.sin(angle);
        }
        return directions;
    }

    /**
     * Gathers.
     *
     * @param place where; takes what is found
     * @param key of all random numbers
     */
    void gather(Place place, long key) {
        long turn = CounterRandom.bits(key, TURN);
        double angle = 2 * Math.PI * CounterRandom.upperFraction(turn);
        double cosine = StrictMath.cos(angle);
        double sine = StrictMath.sin(angle);
        double outwards = CounterRandom.lowerFraction(turn);
        int deep = Math.floorMod(CounterRandom.bits(key, DEEP), RAYS_FOR_A_DEEP_ONE);
        for (int i = 0; i < RAYS; i++) {
            double radius = Math.sqrt((i + outwards) / RAYS);
            u = radius * (cosine * SPIRAL[2 * i] - sine * SPIRAL[2 * i + 1]);
            v = radius * (sine * SPIRAL[2 * i] + cosine * SPIRAL[2 * i + 1]);
            follow(place, CounterRandom.bits(key, i), i % RAYS_FOR_A_DEEP_ONE == deep ? BOUNCES : OWN_BOUNCES);
        }
    }

    private void follow(Place place, long key, int bounces) {
        from.take(place.point());
        path.set(1, 1, 1);
        for (int bounce = 1; bounce <= bounces; bounce++) {
            long bounceKey = CounterRandom.bits(key, bounce);
            LightSum found = lookUpwards(bounceKey);
            if (bounce == 1) {
                place.addNearness(SHARE * vertex.nearness(from));
            }
            if (bounce <= OWN_BOUNCES) {
                place.light.add(SHARE, path, found);
            } else {
                place.deepLight.add(DEEP_SHARE, path, found);
            }
            if (bounce == BOUNCES) {
                place.lastLight.add(DEEP_SHARE, path, found);
                place.arriving.add(DEEP_SHARE, path, Color.WHITE);
            }
            if (!vertex.isFound()) {
                return;
            }
            vertex.filter(path);
            if (bounce == OWN_BOUNCES) {
                place.onward.add(SHARE, path, Color.WHITE);
            } else if (bounce == BOUNCES) {
                place.beyond.add(DEEP_SHARE, path, Color.WHITE);
            }
            from.take(vertex.point());
            drawDirection(bounceKey);
        }
    }

    /** What arrives from the direction above the point (u, v) of the disc that lies on the surface. */
    private LightSum lookUpwards(long key) {
        double w = Math.sqrt(Math.max(0, 1 - (u * u + v * v)));
        basis.turnTo(from.normalX(), from.normalY(), from.normalZ());
        return shader.light(from,
            u * basis.ux() + v * basis.vx() + w * basis.wx(),
            u * basis.uy() + v * basis.vy() + w * basis.wy(),
            u * basis.uz() + v * basis.vz() + w * basis.wz(), key);
    }

    /** A random point of the disc: the first in a row of random points of the square around it. */
    private void drawDirection(long key) {
        long attempt = 0;
        do {
            long bits = CounterRandom.bits(key, attempt++);
            u = 2 * CounterRandom.upperFraction(bits) - 1;
            v = 2 * CounterRandom.lowerFraction(bits) - 1;
        } while (u * u + v * v > 1);
    }
}
