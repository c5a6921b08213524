package raytracing.numerics;

import java.util.stream.IntStream;
import java.util.stream.Stream;
import raytracing.math.Vector;

/** Queries in flat arrays, as a renderer keeps its scene: a benchmark walks them without touching an object. */
public final class Queries {
    /** Numbers of a ray: origin, direction. */
    public static final int RAY = 6;

    /** Numbers of a surface: vector, scalar. */
    public static final int SURFACE = 4;

    private final double[] rays;
    private final double[] surfaces;
    private final int surfacesPerRay;

    private Queries(int rayCount, int surfacesPerRay) {
        this.rays = new double[RAY * rayCount];
        this.surfaces = new double[SURFACE * rayCount * surfacesPerRay];
        this.surfacesPerRay = surfacesPerRay;
    }

    /** The number of queries is rounded up to whole rays. */
    static Queries drawn(Family.Recipe recipe, RandomNumbers random, int count) {
        int perRay = recipe.surfacesPerRay();
        Queries queries = new Queries((count + perRay - 1) / perRay, perRay);
        for (int ray = 0; ray < queries.rayCount(); ray++) {
            Line line = recipe.line().draw(random);
            for (int i = ray * perRay; i < (ray + 1) * perRay; i++) {
                queries.set(i, recipe.surface().draw(random, line));
            }
        }
        return queries;
    }

    private void set(int i, Query query) {
        put(query.origin(), rays, i / surfacesPerRay * RAY);
        put(query.direction(), rays, i / surfacesPerRay * RAY + 3);
        put(query.vector(), surfaces, i * SURFACE);
        surfaces[i * SURFACE + 3] = query.scalar();
    }

    private static void put(Vector v, double[] numbers, int place) {
        numbers[place] = v.x();
        numbers[place + 1] = v.y();
        numbers[place + 2] = v.z();
    }

    private static Vector vector(double[] numbers, int place) {
        return new Vector(numbers[place], numbers[place + 1], numbers[place + 2]);
    }

    /** The query of surface i. */
    Query get(int i) {
        int ray = i / surfacesPerRay * RAY;
        return new Query(vector(rays, ray), vector(rays, ray + 3), vector(surfaces, i * SURFACE),
            surfaces[i * SURFACE + 3]);
    }

    Stream<Query> stream() {
        return IntStream.range(0, size()).mapToObj(this::get);
    }

    int size() {
        return surfaces.length / SURFACE;
    }

    private int rayCount() {
        return rays.length / RAY;
    }

    /**
     * Asks a formula all queries, ray by ray.
     *
     * @return the sum of the crossings that it found
     */
    public double sumOfCrossings(Formula formula) {
        double sum = 0;
        for (int ray = 0; ray < rayCount(); ray++) {
            sum += sumOfCrossings(formula, ray);
        }
        return sum;
    }

    private double sumOfCrossings(Formula formula, int ray) {
        int o = ray * RAY;
        int d = o + 3;
        double ox = rays[o];
        double oy = rays[o + 1];
        double oz = rays[o + 2];
        double dx = rays[d];
        double dy = rays[d + 1];
        double dz = rays[d + 2];
        double sum = 0;
        int end = (ray + 1) * surfacesPerRay * SURFACE;
        for (int s = ray * surfacesPerRay * SURFACE; s < end; s += SURFACE) {
            double t = formula.firstCrossing(ox, oy, oz, dx, dy, dz,
                surfaces[s], surfaces[s + 1], surfaces[s + 2], surfaces[s + 3]);
            if (t < Formula.MISS) {
                sum += t;
            }
        }
        return sum;
    }
}
