package raytracing.estimate;

import raytracing.color.MutableColor;
import raytracing.math.Basis;
import raytracing.math.CounterRandom;
import raytracing.math.Vector;
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
    /** Paths that start at a gather point at once (measured: DECISIONS). */
    static final int PATHS = 48;

    /** One in so many paths is followed further than its first ray, for the light that all gather points share. */
    private static final int PATHS_FOR_A_LONG_ONE = 4;

    /** Rays of a long path, at most. */
    private static final int MOST_RAYS = 8;

    /** Counters of a gather point's random numbers; its paths have those from 0 on. */
    private static final long TURN = -1;
    private static final long LONG = -2;

    private static final double[] SPIRAL = spiral();

    private final VertexReservoir vertex = new VertexReservoir(VertexReservoir.Scattering.DIFFUSE);
    private final Shader shader;
    private final Vector eye;
    private final Hit from = new Hit();
    private final Basis basis = new Basis();
    private final MutableColor share = new MutableColor();
    private MutableColor found = share;
    private long cell;
    private double u;
    private double v;
    private double cosine;
    private double sine;
    private double outwards;

    DiffusePaths(Scene scene, PreparedScene prepared) {
        eye = scene.camera().position();
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

    /**
     * The first paths of a point: what they find waits for the light at their ends; all random numbers are of that key.
     *
     * @param everyPath is long, and not one in four
     */
    void gather(GatherPoint point, boolean everyPath, long key) {
        int every = everyPath ? 1 : PATHS_FOR_A_LONG_ONE;
        int longOne = Math.floorMod(CounterRandom.bits(key, LONG), every);
        PathSegments first = new PathSegments(PATHS);
        PathSegments further = new PathSegments(PATHS / every * (MOST_RAYS - 1));
        double nearness = 0;
        turn(key);
        for (int i = 0; i < PATHS; i++) {
            long pathKey = CounterRandom.bits(key, i);
            followFirst(point, i, pathKey);
            nearness += vertex.nearness(point.hit) / PATHS;
            first.add(FurtherLight.NO_CELL, found, share, cell);
            if (i % every == longOne) {
                followFurther(further, pathKey);
            }
        }
        point.begin(nearness, first, further);
    }

    /** More paths of a point, with the light at their ends. */
    void gatherMore(GatherPoint point, FurtherLight further, long key) {
        turn(key);
        double nearness = 0;
        for (int i = 0; i < PATHS; i++) {
            followFirst(point, i, CounterRandom.bits(key, i));
            nearness += vertex.nearness(point.hit) / PATHS;
            further.addTo(found, share, cell);
            point.add(found);
        }
        point.seeNear(nearness);
    }

    /** The turn of the spiral, as a direction in (u, v), and how far out in its ring each path starts. */
    private void turn(long key) {
        long turn = CounterRandom.bits(key, TURN);
        double angle = 2 * Math.PI * CounterRandom.upperFraction(turn);
        cosine = StrictMath.cos(angle);
        sine = StrictMath.sin(angle);
        outwards = CounterRandom.lowerFraction(turn);
    }

    private void followFirst(GatherPoint point, int i, long key) {
        double radius = Math.sqrt((i + outwards) / PATHS);
        u = radius * (cosine * SPIRAL[2 * i] - sine * SPIRAL[2 * i + 1]);
        v = radius * (sine * SPIRAL[2 * i] + cosine * SPIRAL[2 * i + 1]);
        from.set(point.hit);
        follow(CounterRandom.bits(key, 1));
    }

    /** The rest of a path, from where its first ray ended. */
    private void followFurther(PathSegments segments, long key) {
        for (int ray = 2; ray <= MOST_RAYS && vertex.isFound(); ray++) {
            long start = cell;
            from.set(vertex.hit());
            long rayKey = CounterRandom.bits(key, ray);
            drawDirection(rayKey);
            follow(rayKey);
            segments.add(start, found, share, cell);
        }
    }

    /** Finds what comes from the direction, and where the path may go on. */
    private void follow(long key) {
        found = lightFromAbove(key);
        share.clear();
        cell = FurtherLight.NO_CELL;
        if (vertex.isFound()) {
            share.set(1, 1, 1);
            vertex.filter(share);
            cell = FurtherLight.cell(vertex.hit(), eye);
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
