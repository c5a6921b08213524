package raytracing.shade;

import raytracing.color.Color;
import raytracing.geometry.HitPoint;

/** A point that the camera sees, and the light that was gathered there. */
final class Place {
    /** What a place tells of its surroundings reaches so far, in mean distances (measured: DECISIONS). */
    private static final double REACH = 0.35;

    /**
     * The least that it reaches, in distances between places: so most points lie between several of them. On a surface
     * that the eye looks along they lie further apart in one direction: a circle as large as their ellipse reaches
     * further, within a limit.
     */
    private static final double LEAST_REACH = 2;
    private static final double LEAST_FACING = 0.1;

    /** The most that it reaches: what a few rays have missed is not far away. */
    private static final double MOST_REACH = 6;

    /** So many times further away than usual, places stand in for others. */
    private static final double WIDENING = 3;

    /** Not more than 64 times again where the eye looks along a surface: then nearly all places are far apart. */
    private static final double LEAST_FACING_WIDE = 0x1p-6;

    /** Mean over the hemisphere of the light that arrives by the first bounces: what is the place's own. */
    final LightSum light = new LightSum();

    /** Mean weight of what arrives, by further bounces, where the paths of that light end. */
    final LightSum onward = new LightSum();

    /** What those that were followed brought of it. */
    final LightSum deepLight = new LightSum();

    /** The part of that which came by the last bounce. */
    final LightSum lastLight = new LightSum();

    /** Mean weight of the rays that looked for that part. */
    final LightSum arriving = new LightSum();

    /** Mean weight of what arrives, by still further bounces, where these rays end. */
    final LightSum beyond = new LightSum();

    private final HitPoint point = new HitPoint();
    private final double spacing;
    private final double facing;
    private double nearness;
    private boolean isChosen;

    /**
     * A place where nothing was gathered yet.
     *
     * @param seen the point
     * @param spacing distance of places around it, were they all on a sphere around the eye
     * @param facing cosine between its normal and the direction to the eye
     */
    Place(HitPoint seen, double spacing, double facing) {
        point.take(seen);
        this.spacing = spacing;
        this.facing = facing;
    }

    HitPoint point() {
        return point;
    }

    /** Light is gathered at a place once. */
    boolean isChosen() {
        return isChosen;
    }

    void choose() {
        isChosen = true;
    }

    /** Adds to the mean of one over the distance to what is around. */
    void addNearness(double share) {
        nearness += share;
    }

    /**
     * How far around the light of this place is that of others: in proportion to the harmonic mean of the distances to
     * what is around, as Ward and others have it, within limits.
     */
    double radius() {
        double least = LEAST_REACH * spacing / Math.sqrt(Math.max(facing, LEAST_FACING));
        return Math.min(MOST_REACH * spacing, Math.max(least, REACH / nearness));
    }

    /**
     * How far around it stands in for places that are missing: further where the eye looks along a surface, for there
     * they lie far apart.
     */
    double wideRadius() {
        return WIDENING * radius() / Math.max(facing, LEAST_FACING_WIDE);
    }

    /** All light that arrives, if {@code further} arrives, by further bounces, where the paths of its own light end. */
    Color allLight(Color further) {
        return new Color(light.red() + onward.red() * further.red(), light.green() + onward.green() * further.green(),
            light.blue() + onward.blue() * further.blue());
    }
}
