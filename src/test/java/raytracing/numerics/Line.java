package raytracing.numerics;

import raytracing.math.Vector;

/** A ray that still wants its surface. */
record Line(Vector origin, Vector direction) {
    Vector at(double t) {
        return origin.plus(t, direction);
    }

    Query with(Vector vector, double scalar) {
        return new Query(origin, direction, vector, scalar);
    }
}
