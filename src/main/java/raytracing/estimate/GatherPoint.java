package raytracing.estimate;

import raytracing.ambient.IrradianceRecord;
import raytracing.color.Color;
import raytracing.color.MutableColor;
import raytracing.math.Vector;
import raytracing.surface.Hit;

/** A point that the camera sees, and the light that is gathered there. Not thread-safe. */
final class GatherPoint {
    /** The radius of its record in harmonic mean distances (measured: DECISIONS). */
    private static final double RADIUS = 0.2;

    /**
     * The least radius, in distances between gather points: so most points lie between several of them. On a surface that
     * the eye looks along, gather points lie further apart in one direction: a circle as large as their ellipse has a larger
     * radius, within a limit.
     */
    private static final double LEAST_RADIUS = 2;
    private static final double LEAST_FACING = 0.1;

    /** The greatest radius: what a few rays have missed is not far away. */
    private static final double GREATEST_RADIUS = 10;

    /** How many times larger the radius is where other records are missing. */
    private static final double WIDENING = 3;

    /** Not more than 64 times again where the eye looks along a surface: then nearly all gather points are far apart. */
    private static final double LEAST_FACING_WIDE = 0x1p-6;

    final Hit hit = new Hit();

    /** What the picture shows there without ambient light, and how much light it shows for each unit of ambient light. */
    final MutableColor shownWithout = new MutableColor();
    final MutableColor shownOfAmbient = new MutableColor();

    /** Whether light is gathered here; once for each point. */
    boolean isChosen;

    private final double spacing;
    private final double facing;

    /** Mean of one over the distance to the surroundings. */
    private double nearness;

    private PathSegments first = new PathSegments(0);
    private PathSegments further = first;

    /** Light that paths brought, every other one apart: what the two halves differ in is chance. */
    private final MutableColor evenLight = new MutableColor();
    private final MutableColor oddLight = new MutableColor();
    private int paths;

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

    /** Gets its first paths. */
    void begin(double meanNearness, PathSegments firstRays, PathSegments furtherRays) {
        nearness = meanNearness;
        first = firstRays;
        further = furtherRays;
    }

    /** Rays of its paths that did not start here. */
    PathSegments further() {
        return further;
    }

    /** Adds the light where its first paths' first rays ended, and forgets these. */
    void settle(FurtherLight furtherLight) {
        MutableColor light = new MutableColor();
        MutableColor share = new MutableColor();
        for (int i = 0; i < first.count(); i++) {
            light.set(first.light(i, 0), first.light(i, 1), first.light(i, 2));
            share.set(first.onward(i, 0), first.onward(i, 1), first.onward(i, 2));
            furtherLight.addTo(light, share, first.to(i));
            add(light);
        }
        first = new PathSegments(0);
        further = first;
    }

    /** Adds what one more path brought. */
    void add(MutableColor light) {
        (paths % 2 == 0 ? evenLight : oddLight).add(1, Color.WHITE, light);
        paths++;
    }

    /** Gets what paths added at once know of the distance to the surroundings. */
    void seeNear(double meanNearness) {
        if (nearness == 0) {
            nearness = meanNearness;
        }
    }

    int paths() {
        return paths;
    }

    /**
     * In proportion to the harmonic mean of the distances to the surroundings, as Ward and others have it, within limits.
     *
     * @param detail 1, or less to put records closer to each other
     */
    double radius(double detail) {
        double least = LEAST_RADIUS * spacing / Math.sqrt(Math.max(facing, LEAST_FACING));
        return detail * Math.min(GREATEST_RADIUS * spacing, Math.max(least, RADIUS / nearness));
    }

    /** The radius where other records are missing: larger where the eye looks along a surface, as they lie far apart there. */
    double wideRadius(double detail) {
        return WIDENING * radius(detail) / Math.max(facing, LEAST_FACING_WIDE);
    }

    /** How much of the picture its record counts in. */
    double area(double detail) {
        double cells = radius(detail) / spacing;
        return cells * cells * facing;
    }

    /** The mean of all light that arrives. */
    Color light() {
        return mean(evenLight.red() + oddLight.red(), evenLight.green() + oddLight.green(),
            evenLight.blue() + oddLight.blue(), paths);
    }

    /** The same by half of the paths, which are independent of the other half. */
    Color lightOfEvenPaths() {
        return mean(evenLight.red(), evenLight.green(), evenLight.blue(), (paths + 1) / 2);
    }

    Color lightOfOddPaths() {
        return mean(oddLight.red(), oddLight.green(), oddLight.blue(), paths / 2);
    }

    private static Color mean(double red, double green, double blue, int count) {
        return new Color(Math.min(red / count, Double.MAX_VALUE), Math.min(green / count, Double.MAX_VALUE),
            Math.min(blue / count, Double.MAX_VALUE));
    }

    /** A record of this point with some radius and light. */
    IrradianceRecord toRecord(double radius, Color light) {
        return new IrradianceRecord(new Vector(hit.x(), hit.y(), hit.z()),
            new Vector(hit.normalX(), hit.normalY(), hit.normalZ()), radius, light);
    }
}
