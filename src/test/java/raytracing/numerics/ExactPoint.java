package raytracing.numerics;

import raytracing.math.Vector;

/** A point or a way of exact numbers. Independent of the product. */
record ExactPoint(ExactNumber x, ExactNumber y, ExactNumber z) {
    static ExactPoint of(Vector v) {
        return new ExactPoint(ExactNumber.of(v.x()), ExactNumber.of(v.y()), ExactNumber.of(v.z()));
    }

    ExactPoint plus(ExactPoint other) {
        return new ExactPoint(x.plus(other.x), y.plus(other.y), z.plus(other.z));
    }

    ExactPoint minus(ExactPoint other) {
        return new ExactPoint(x.minus(other.x), y.minus(other.y), z.minus(other.z));
    }

    ExactPoint times(ExactNumber factor) {
        return new ExactPoint(x.times(factor), y.times(factor), z.times(factor));
    }

    ExactNumber dot(ExactPoint other) {
        return x.times(other.x).plus(y.times(other.y)).plus(z.times(other.z));
    }

    ExactPoint cross(ExactPoint other) {
        return new ExactPoint(y.times(other.z).minus(z.times(other.y)), z.times(other.x).minus(x.times(other.z)),
            x.times(other.y).minus(y.times(other.x)));
    }

    boolean isZero() {
        return x.signum() == 0 && y.signum() == 0 && z.signum() == 0;
    }
}
