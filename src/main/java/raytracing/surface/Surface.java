package raytracing.surface;

import java.util.Optional;
import raytracing.math.Surd;

/**
 * A surface of the scene, and everything about it and a ray. World axes, lengths in scene units. Immutable.
 *
 * <p>Surfaces do not know their number in the scene, counted from 0; methods to which it matters whether a ray starts on
 * this surface take it. Decisions are those of the real numbers: doubles make them where a bound on their error, known
 * beforehand, lets them, and exact numbers elsewhere.
 */
public sealed interface Surface permits Bounded, Plane {
    /** "No crossing": beyond every distance, so that comparing distances needs no special case. */
    double MISS = Double.POSITIVE_INFINITY;

    /** "Doubles cannot tell": NaN, so that every comparison with a distance is false. */
    double UNDECIDED = Double.NaN;

    /** Number of the surface's material, counted from 0 in the order of the scene. */
    int material();

    /**
     * Distance along a ray to its first crossing, by doubles alone.
     *
     * @param ray not starting on this surface by its number
     * @param latest crossings certainly beyond this distance may be reported as {@link #MISS}
     * @return smallest t above 0 in multiples of the ray's direction, with an error of at most 16 units in the last place
     *         (sphere: measured; others: proved); {@link #MISS}; or {@link #UNDECIDED}, also if the origin's error
     *         leaves open on which side of the surface the ray starts
     */
    double firstCrossing(Ray ray, double latest);

    /**
     * The first crossing of a ray, exactly. A ray that starts inside a body crosses its wall from inside; one that starts on
     * the surface, and heads to the other side than that from which its origin was seen, crosses it at once.
     *
     * @return smallest t of at least 0 with origin + t direction on the surface, if there is one
     */
    Optional<Surd> exactCrossing(Ray ray, int number);

    /** Whether a segment that does not start on this surface by its number enters or leaves it strictly between its ends. */
    boolean isCrossed(Segment segment, int number);

    /**
     * On which side of this surface a point lies, decided exactly.
     *
     * @return 1 outside a body or where the normal of a plane or triangle points, -1 inside or on the other side; 0 if the
     *         point is on the surface within its error, and nothing tells from which side it was seen
     */
    int side(RayOrigin point, int number);

    /** Whether another surface is the same set of points, written with the same numbers. */
    boolean isInPlaceOf(Surface other);

    /**
     * Computes point and normal of a crossing. The point is at origin + distance direction or nearer to the surface than
     * that; at distance 0 it is the origin itself.
     *
     * @param distance of the crossing, finite
     * @param hit takes the result
     */
    void describe(Ray ray, int number, double distance, Hit hit);

    /** Calls the visitor's method for this kind of surface. */
    <R> R accept(Visitor<R> visitor);

    /** One method for every kind of surface, so that with a new kind no code compiles that forgets it. */
    interface Visitor<R> {
        R visit(Sphere sphere);

        R visit(Plane plane);

        R visit(Box box);

        R visit(Triangle triangle);
    }

    /**
     * An exact crossing as a double.
     *
     * @return the nearest double; above 0, the nearest that is above 0 and finite; {@link #MISS} if there is no crossing
     */
    static double distance(Optional<Surd> crossing) {
        if (crossing.isEmpty()) {
            return MISS;
        }
        Surd exact = crossing.get();
        return exact.signum() == 0 ? 0
            : Math.max(Double.MIN_VALUE, Math.min(Double.MAX_VALUE, exact.doubleValue()));
    }
}
