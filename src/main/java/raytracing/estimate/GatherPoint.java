package raytracing.estimate;

import raytracing.ambient.IrradianceRecord;
import raytracing.color.Color;
import raytracing.color.MutableColor;
import raytracing.math.Vector;
import raytracing.surface.Hit;

/** A point that the camera sees, and the light that is gathered there. Not thread-safe. */
final class GatherPoint {
    /** The radius of its record in harmonic mean distances (measured: DECISIONS). */
    private static final double RADIUS = 0.35;

    /**
     * The least radius, in distances between gather points: so most points lie between several of them. On a surface that
     * the eye looks along, gather points lie further apart in one direction: a circle as large as their ellipse has a larger
     * radius, within a limit.
     */
    private static final double LEAST_RADIUS = 2;
    private static final double LEAST_FACING = 0.1;

    /** The greatest radius: what a few rays have missed is not far away. */
    private static final double GREATEST_RADIUS = 6;

    /** How many times larger the radius is where other records are missing. */
    private static final double WIDENING = 3;

    /** Not more than 64 times again where the eye looks along a surface: then nearly all gather points are far apart. */
    private static final double LEAST_FACING_WIDE = 0x1p-6;

    final Hit hit = new Hit();

    /** Mean over the hemisphere of the light that arrives by the first bounces. */
    final MutableColor ownLight = new MutableColor();

    final FurtherBounces further = new FurtherBounces();

    /** Mean of one over the distance to the surroundings. */
    double nearness;

    /** Whether light is gathered here; once for each point. */
    boolean isChosen;

    private final double spacing;
    private final double facing;

    /**
     * A point where no light was gathered yet.
     *
     * @param spacing distance of gather points around it, were they all on a sphere around the eye
     * @param facing cosine between its normal and the direction to the eye
     */
    GatherPoint(Hit hit, double spacing, double facing) {
        this.hit.set(hit);
        this.spacing = spacing;
        this.facing = facing;
    }

    /** In proportion to the harmonic mean of the distances to the surroundings, as Ward and others have it, within limits. */
    double radius() {
        double least = LEAST_RADIUS * spacing / Math.sqrt(Math.max(facing, LEAST_FACING));
        return Math.min(GREATEST_RADIUS * spacing, Math.max(least, RADIUS / nearness));
    }

    /** The radius where other records are missing: larger where the eye looks along a surface, as they lie far apart there. */
    double wideRadius() {
        return WIDENING * radius() / Math.max(facing, LEAST_FACING_WIDE);
    }

    /** All light that arrives, if {@code furtherLight} arrives where the paths of its own light end. */
    Color light(Color furtherLight) {
        MutableColor onward = further.onward;
        return new Color(ownLight.red() + onward.red() * furtherLight.red(),
            ownLight.green() + onward.green() * furtherLight.green(), ownLight.blue() + onward.blue() * furtherLight.blue());
    }

    /** A record of this point with some radius and light. */
    IrradianceRecord toRecord(double radius, Color light) {
        return new IrradianceRecord(new Vector(hit.x(), hit.y(), hit.z()),
            new Vector(hit.normalX(), hit.normalY(), hit.normalZ()), radius, light);
    }
}
