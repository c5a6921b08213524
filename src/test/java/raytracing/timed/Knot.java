package raytracing.timed;

import java.util.ArrayList;
import java.util.List;
import raytracing.color.Color;
import raytracing.math.Vector;
import raytracing.math.Vectors;
import raytracing.scene.Camera;
import raytracing.scene.Light;
import raytracing.scene.Material;
import raytracing.scene.Pinhole;
import raytracing.scene.Scene;
import raytracing.scene.Settings;
import raytracing.surface.Plane;
import raytracing.surface.Surface;
import raytracing.surface.Triangle;

/**
 * A closed mesh: a tube around a trefoil knot, which winds twice around the y axis and three times around a ring, and so lies
 * on a torus. The tube is a ring of points around each of many points of the knot; the four-sided pieces between two rings are
 * cut in two triangles, whose normals point outward.
 */
public final class Knot {
    /** Of the ring around which the knot winds, of the torus on which it lies, and of the tube. */
    static final double RING = 1;
    static final double TORUS = 0.4;
    static final double TUBE = 0.25;

    private static final int AROUND_THE_AXIS = 2;
    private static final int AROUND_THE_RING = 3;
    private static final double FLOOR = -0.7;
    private static final int GROUND = 0;
    private static final int SKIN = 1;
    private static final int RECURSION = 4;

    private Knot() {
    }

    /**
     * A knot over a matte floor under three lamps, as a {@link Sphereflake}. The floor comes after the last triangle.
     *
     * @param along number of rings, at least 3; there are 2 x along x around triangles
     * @param around number of points of a ring, at least 3
     * @param shadowRayRoot N: each of the lamps is sampled by N x N shadow rays
     */
    public static Scene scene(int along, int around, int shadowRayRoot) {
        List<Surface> surfaces = new ArrayList<>();
        List<Vector> first = ring(0, along, around);
        List<Vector> ring = first;
        for (int i = 1; i <= along; i++) {
            List<Vector> next = i == along ? first : ring(i, along, around);
            for (int j = 0; j < around; j++) {
                Vector a = ring.get(j);
                Vector b = ring.get((j + 1) % around);
                Vector c = next.get((j + 1) % around);
                surfaces.add(Triangle.of(a, b, c, SKIN));
                surfaces.add(Triangle.of(a, c, next.get(j), SKIN));
            }
            ring = next;
        }
        surfaces.add(new Plane(new Vector(0, 1, 0), FLOOR, GROUND));
        return new Scene(
            new Camera(new Vector(3.5, 3, 3), new Vector(0, -0.1, 0), new Vector(0, 1, 0), 1, 0.7, new Pinhole()),
            new Settings(new Color(0.08, 0.36, 0.75), shadowRayRoot, RECURSION, 1),
            List.of(
                new Material(new Color(0.8, 0.6, 0.27), Color.BLACK, Color.BLACK, 1, 0, Color.BLACK),
                new Material(new Color(0.5, 0.45, 0.35), grey(0.5), grey(0.2), 20, 0, Color.BLACK)),
            surfaces,
            List.of(lamp(8, 4, 6), lamp(2, 8, -8), lamp(-6, 10, 2)));
    }

    /** The points of a ring around one point of the knot, in the plane across it. */
    private static List<Vector> ring(int i, int along, int around) {
        double t = 2 * Math.PI * i / along;
        Vector outward = Vectors.plus(fromAxis(t).times(StrictMath.cos(AROUND_THE_RING * t)),
            StrictMath.sin(AROUND_THE_RING * t), new Vector(0, 1, 0));
        Vector across = tangent(t).cross(outward);
        List<Vector> points = new ArrayList<>();
        for (int j = 0; j < around; j++) {
            double angle = 2 * Math.PI * j / around;
            Vector direction = Vectors.plus(outward.times(StrictMath.cos(angle)), StrictMath.sin(angle), across);
            points.add(NineDigits.of(Vectors.plus(centre(t), TUBE, direction)));
        }
        return points;
    }

    /** A point of the knot, from 0 to 2 pi. */
    static Vector centre(double t) {
        double fromTheAxis = RING + TORUS * StrictMath.cos(AROUND_THE_RING * t);
        return Vectors.plus(fromAxis(t).times(fromTheAxis), TORUS * StrictMath.sin(AROUND_THE_RING * t), new Vector(0, 1, 0));
    }

    /** The unit vector from the y axis to a point of the knot. */
    private static Vector fromAxis(double t) {
        return new Vector(StrictMath.cos(AROUND_THE_AXIS * t), 0, StrictMath.sin(AROUND_THE_AXIS * t));
    }

    /** The direction of the knot, which is at right angles to the torus's normal. */
    private static Vector tangent(double t) {
        double fromTheAxis = RING + TORUS * StrictMath.cos(AROUND_THE_RING * t);
        Vector aroundTheAxis = new Vector(-StrictMath.sin(AROUND_THE_AXIS * t), 0, StrictMath.cos(AROUND_THE_AXIS * t));
        Vector aroundTheRing = Vectors.plus(fromAxis(t).times(-StrictMath.sin(AROUND_THE_RING * t)),
            StrictMath.cos(AROUND_THE_RING * t), new Vector(0, 1, 0));
        return Vectors.plus(aroundTheAxis.times(AROUND_THE_AXIS * fromTheAxis), AROUND_THE_RING * TORUS, aroundTheRing).unit();
    }

    private static Light lamp(double x, double y, double z) {
        return new Light(new Vector(x, y, z), grey(0.5), 1, 1, 1);
    }

    private static Color grey(double share) {
        return new Color(share, share, share);
    }
}
