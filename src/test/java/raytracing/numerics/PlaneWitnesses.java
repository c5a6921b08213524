package raytracing.numerics;

import raytracing.surface.Plane;

/** Plane formulas that lose, and one that wins at any price: what ours is measured against. */
final class PlaneWitnesses {
    private PlaneWitnesses() {
    }

    static double textbook(double ox, double oy, double oz, double dx, double dy, double dz,
                           double nx, double ny, double nz, double c) {
        double t = (c - (nx * ox + ny * oy + nz * oz)) / (nx * dx + ny * dy + nz * dz);
        return t > 0 ? t : Formula.MISS;
    }

    static double fused(double ox, double oy, double oz, double dx, double dy, double dz,
                        double nx, double ny, double nz, double c) {
        double ahead = Math.fma(-nx, ox, Math.fma(-ny, oy, Math.fma(-nz, oz, c)));
        double approach = Math.fma(nx, dx, Math.fma(ny, dy, nz * dz));
        double t = ahead / approach;
        return t > 0 ? t : Formula.MISS;
    }

    static double doubleDouble(double ox, double oy, double oz, double dx, double dy, double dz,
                               double nx, double ny, double nz, double c) {
        DoubleDoubleVector normal = DoubleDoubleVector.of(nx, ny, nz);
        DoubleDouble ahead = DoubleDouble.of(c).minus(normal.dot(DoubleDoubleVector.of(ox, oy, oz)));
        DoubleDouble approach = normal.dot(DoubleDoubleVector.of(dx, dy, dz));
        double t = ahead.dividedBy(approach).high();
        return t > 0 ? t : Formula.MISS;
    }
}
