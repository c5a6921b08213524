package raytracing.numerics;

import raytracing.math.Vector;
import raytracing.math.Vectors;

/** A ray that still wants its surface. */
record Line(Vector origin, Vector direction) {
    Vector at(double t) {
        return Vectors.plus(origin, t, direction);
    }

    Query with(Vector vector, double scalar) {
        return new Query(origin, direction, vector, scalar);
    }
}
