package raytracing.estimate;

import raytracing.color.Color;
import raytracing.color.MutableColor;
import raytracing.math.Basis;
import raytracing.math.CounterRandom;
import raytracing.scene.Scene;
import raytracing.shade.Shader;
import raytracing.shade.VertexReservoir;
import raytracing.surface.Hit;
import raytracing.trace.PreparedScene;

/**
 * Gathers the light that arrives at a point from everywhere but the lamps, by random paths from surface to surface (Kajiya,
 * The Rendering Equation, SIGGRAPH 1986). Not thread-safe.
 *
 * <p>Each ray brings what the picture would show along it, without ambient light and with hard shadows, and the path goes on
 * from one of the points that the ray met. Directions are drawn in proportion to their cosine: from points of the unit disc,
 * lifted to the hemisphere above it (Malley's method: Pharr, Jakob, Humphreys, Physically Based Rendering, section on
 * cosine-weighted hemisphere sampling). The first rays from a point go through a spiral that covers the disc evenly (Vogel,
 * A better way to construct the sunflower head, Mathematical Biosciences 44, 1979), turned by a random angle.
 */
final class DiffusePaths {
    /** Paths that start at each gather point (measured: DECISIONS). */
    static final int PATHS = 48;

    /** The light of so many bounces is each gather point's own; that of further ones differs little from point to point. */
    private static final int OWN_BOUNCES = 2;

    /** Bounces that are followed; those beyond are summed up from the last one's (measured: DECISIONS). */
    private static final int BOUNCES = 4;

    /** One in so many paths is followed further than its own bounces: their light is used by all gather points together. */
    private static final int PATHS_FOR_A_DEEP_ONE = 4;

    private static final double SHARE = 1.0 / PATHS;
    private static final double DEEP_SHARE = PATHS_FOR_A_DEEP_ONE * SHARE;

    /** Counters of a gather point's random numbers; its paths have those from 0 on. */
    private static final long TURN = -1;
    private static final long DEEP = -2;

    private static final double[] SPIRAL = spiral();

    private final VertexReservoir vertex = new VertexReservoir(VertexReservoir.Scattering.DIFFUSE);
    private final Shader shader;
    private final Hit from = new Hit();
    private final Basis basis = new Basis();
    private final MutableColor weight = new MutableColor();
    private double u;
    private double v;

    DiffusePaths(Scene scene, PreparedScene prepared) {
        shader = Shader.forEstimates(scene, prepared, vertex);
    }

    /** Directions in the disc, each turned from the one before by the golden angle. */
    private static double[] spiral() {
        double[] directions = new double[2 * PATHS];
        for (int i = 0; i < PATHS; i++) {
            double angle = i * Math.PI * (3 - Math.sqrt(5));
            directions[2 * i] = StrictMath.cos(angle);
            directions[2 * i + 1] = StrictMath.sin(angle);
        }
        return directions;
    }

    /** Gathers light at a point; all random numbers are of that key. */
    void gather(GatherPoint point, long key) {
        long turn = CounterRandom.bits(key, TURN);
        double angle = 2 * Math.PI * CounterRandom.upperFraction(turn);
        double cosine = StrictMath.cos(angle);
        double sine = StrictMath.sin(angle);
        double outwards = CounterRandom.lowerFraction(turn);
        int deep = Math.floorMod(CounterRandom.bits(key, DEEP), PATHS_FOR_A_DEEP_ONE);
        for (int i = 0; i < PATHS; i++) {
            double radius = Math.sqrt((i + outwards) / PATHS);
            u = radius * (cosine * SPIRAL[2 * i] - sine * SPIRAL[2 * i + 1]);
            v = radius * (sine * SPIRAL[2 * i] + cosine * SPIRAL[2 * i + 1]);
            follow(point, CounterRandom.bits(key, i), i % PATHS_FOR_A_DEEP_ONE == deep ? BOUNCES : OWN_BOUNCES);
        }
    }

    private void follow(GatherPoint point, long key, int bounces) {
        FurtherBounces further = point.further;
        from.set(point.hit);
        weight.set(1, 1, 1);
        for (int bounce = 1; bounce <= bounces; bounce++) {
            long bounceKey = CounterRandom.bits(key, bounce);
            MutableColor found = lightFromAbove(bounceKey);
            if (bounce == 1) {
                point.nearness += SHARE * vertex.nearness(from);
            }
            if (bounce <= OWN_BOUNCES) {
                point.ownLight.add(SHARE, weight, found);
            } else {
                further.light.add(DEEP_SHARE, weight, found);
            }
            if (bounce == BOUNCES) {
                further.lastLight.add(DEEP_SHARE, weight, found);
                further.arriving.add(DEEP_SHARE, weight, Color.WHITE);
            }
            if (!vertex.isFound()) {
                return;
            }
            vertex.filter(weight);
            if (bounce == OWN_BOUNCES) {
                further.onward.add(SHARE, weight, Color.WHITE);
            } else if (bounce == BOUNCES) {
                further.beyond.add(DEEP_SHARE, weight, Color.WHITE);
            }
            from.set(vertex.hit());
            drawDirection(bounceKey);
        }
    }

    /** The light that arrives from the direction above the point (u, v) of the disc that lies on the surface. */
    private MutableColor lightFromAbove(long key) {
        double w = Math.sqrt(Math.max(0, 1 - (u * u + v * v)));
        basis.turnTo(from.normalX(), from.normalY(), from.normalZ());
        return shader.light(from,
            u * basis.ux() + v * basis.vx() + w * basis.wx(),
            u * basis.uy() + v * basis.vy() + w * basis.wy(),
            u * basis.uz() + v * basis.vz() + w * basis.wz(), key);
    }

    /** Sets (u, v) to a random point of the disc: the first inside it of random points of the square around it. */
    private void drawDirection(long key) {
        long attempt = 0;
        do {
            long bits = CounterRandom.bits(key, attempt++);
            u = 2 * CounterRandom.upperFraction(bits) - 1;
            v = 2 * CounterRandom.lowerFraction(bits) - 1;
        } while (u * u + v * v > 1);
    }
}
