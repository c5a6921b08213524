package raytracing.numerics;

import raytracing.math.Vector;
import raytracing.surface.Hit;
import raytracing.trace.PreparedScene;
import raytracing.trace.RayQuery;
import raytracing.trace.SegmentQuery;

/**
 * A point that a walk has reached, kept while walks and lines go on from there. The one place of these tests that knows
 * how the product is asked to go on.
 *
 * @param point the product's
 */
record Joint(Hit point) {
    /** A copy of the walk's point. */
    static Joint reachedBy(RayQuery walk) {
        Hit copy = new Hit();
        copy.set(walk.hit());
        return new Joint(copy);
    }

    /** Number of the surface that was reached. */
    int surface() {
        return point.surface();
    }

    Vector position() {
        return new Vector(point.x(), point.y(), point.z());
    }

    /** The unit normal of the surface reached, to the side from which it was. */
    Vector normal() {
        return new Vector(point.normalX(), point.normalY(), point.normalZ());
    }

    /** Starts a walk from here, as a mirrored ray does. */
    void start(RayQuery walk, Vector direction) {
        walk.start(point.origin(), direction.x(), direction.y(), direction.z());
    }

    /** How much light comes here from a point. */
    double transmittance(PreparedScene scene, Vector end) {
        return new SegmentQuery(scene, 1).transmittance(point, 0, end.x(), end.y(), end.z(), 0);
    }
}
