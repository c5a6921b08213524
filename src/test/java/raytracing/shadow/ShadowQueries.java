package raytracing.shadow;

import java.util.SplittableRandom;
import raytracing.SceneText;
import raytracing.math.Vector;
import raytracing.surface.HitRecord;
import raytracing.surface.PointError;
import raytracing.surface.RayRecord;
import raytracing.trace.PreparedScene;
import raytracing.trace.Queries;
import raytracing.trace.RayQuery;
import raytracing.trace.ShadowMode;

/**
 * Random questions about soft shadows: a few random surfaces, a point on one of them, seen from outside or inside, and
 * a light anywhere, which may cut surfaces. Only those that neither "all" nor "nothing" answers.
 */
public final class ShadowQueries {
    private static final double SPREAD = 4;
    private static final int RAYS_IN_A_SCENE = 12;

    /** A first look, to leave out what is plainly lit or dark. */
    private static final int ROOT_OF_FIRST_LOOK = 12;

    private final SplittableRandom random;
    private final String head;
    private final int materials;
    private final boolean hasTriangles;
    private String surfaces;
    private PreparedScene scene;
    private RayQuery walk;
    private int raysLeft;

    /**
     * A sequence of questions.
     *
     * @param seed of the sequence
     * @param transmittances of the materials; 0 is opaque
     */
    public ShadowQueries(long seed, double... transmittances) {
        this(false, seed, transmittances);
    }

    private ShadowQueries(boolean hasTriangles, long seed, double... transmittances) {
        this.hasTriangles = hasTriangles;
        random = new SplittableRandom(seed);
        StringBuilder lines = new StringBuilder("cam 0 0 -5 0 0 0 0 1 0 1 1\nset 0 0 0 1 1\n");
        for (double transmittance : transmittances) {
            lines.append("mtl 1 1 1 0 0 0 0 0 0 1 ").append(transmittance).append('\n');
        }
        head = lines.toString();
        materials = transmittances.length;
        startScene();
    }

    /** The same among surfaces of which most are triangles. */
    public static ShadowQueries amongTriangles(long seed, double... transmittances) {
        return new ShadowQueries(true, seed, transmittances);
    }

    private void startScene() {
        surfaces = hasTriangles ? new RandomTriangles(random, materials).crowd(random.nextInt(1, 12), SPREAD) : crowd();
        scene = prepared(surfaces);
        walk = new RayQuery(scene);
        raysLeft = RAYS_IN_A_SCENE;
    }

    /**
     * A point and a light.
     *
     * @param scene the surfaces
     * @param hit the point
     * @param light middle of the light
     * @param width of the light
     * @param surfaces as lines of a scene file, for messages
     */
    public record Query(PreparedScene scene, HitRecord hit, Vector light, double width, String surfaces) {
        /** A shaft to the light. */
        ShaftQuery shaft(ShaftQuery.Use use) {
            ShaftQuery shaft = new ShaftQuery(scene, use, 1);
            shaft.aim(hit.toHit(), 0, light.x(), light.y(), light.z(), PointError.written(light), width);
            return shaft;
        }

        /** What areas say. */
        public double exact() {
            return new ExactShadows(scene, 1).meanTransmittance(shaft(ShaftQuery.Use.AREAS), 1);
        }
    }

    /** What comes through along the line to one point of the light's square, of a shaft that is not settled. */
    static double transmittance(ShaftQuery shaft, double x, double y) {
        LightSamples point = new LightSamples();
        point.x[0] = x;
        point.y[0] = y;
        point.squaredDistance[0] = x * x + y * y + shaft.shaft.depth * shaft.shaft.depth;
        point.transmittance[0] = 1;
        point.count = 1;
        shaft.findTransmittances(point);
        return point.transmittance[0];
    }

    private PreparedScene prepared(String surfaces) {
        return Queries.prepared(SceneText.scene(head + surfaces), ShadowMode.TRANSPARENT_SURFACES_PASS_LIGHT);
    }

    /** The next question in whose answer there is some doubt. */
    public Query next() {
        while (true) {
            if (raysLeft == 0) {
                startScene();
            }
            raysLeft--;
            Queries.start(walk, new RayRecord(vector(SPREAD + 2), vector(1)));
            Vector light = vector(2 * SPREAD);
            double width = random.nextDouble(0.05, 4);
            if (walk.advance() && light.minus(Queries.hit(walk).point()).length() > 1e-3) {
                Query query = new Query(scene, Queries.hit(walk), light, width, surfaces);
                if (isPartlySeen(query)) {
                    return query;
                }
            }
        }
    }

    private boolean isPartlySeen(Query query) {
        ShaftQuery shaft = query.shaft(ShaftQuery.Use.LINES);
        if (shaft.isSettled()) {
            return false;
        }
        double first = transmittance(shaft, 0, 0);
        double sum = shaft.sumOverCells(ROOT_OF_FIRST_LOOK, random.nextLong());
        return Math.abs(sum - first * ROOT_OF_FIRST_LOOK * ROOT_OF_FIRST_LOOK) > 1e-9;
    }

    private String crowd() {
        String[] codes = {"sph", "sph", "box", "pln"};
        StringBuilder lines = new StringBuilder();
        int size = random.nextInt(1, 9);
        for (int i = 0; i < size; i++) {
            Vector place = vector(SPREAD);
            lines.append(codes[random.nextInt(codes.length)]).append(' ').append(place.x()).append(' ')
                .append(place.y()).append(' ').append(place.z()).append(' ').append(random.nextDouble(0.2, 2))
                .append(' ').append(random.nextInt(1, materials + 1)).append('\n');
        }
        return lines.toString();
    }

    private Vector vector(double size) {
        return new Vector(random.nextDouble(-size, size), random.nextDouble(-size, size), random.nextDouble(-size, size));
    }
}
