package raytracing.math;

/** Operations on vectors that only tests need. */
public final class Vectors {
    private Vectors() {
    }

    public static Vector plus(Vector a, Vector b) {
        return new Vector(a.x() + b.x(), a.y() + b.y(), a.z() + b.z());
    }

    /** The point a + distance times direction. */
    public static Vector plus(Vector a, double distance, Vector direction) {
        return new Vector(a.x() + distance * direction.x(), a.y() + distance * direction.y(),
            a.z() + distance * direction.z());
    }

    public static Vector negated(Vector vector) {
        return new Vector(-vector.x(), -vector.y(), -vector.z());
    }

    /** The vectors of a {@link Basis}. */
    public record Axes(Vector u, Vector v, Vector w) {
    }

    /** What {@link Basis#turnTo} makes of the direction. */
    public static Axes around(Vector direction) {
        Basis basis = new Basis();
        basis.turnTo(direction.x(), direction.y(), direction.z());
        return new Axes(new Vector(basis.ux(), basis.uy(), basis.uz()), new Vector(basis.vx(), basis.vy(), basis.vz()),
            new Vector(basis.wx(), basis.wy(), basis.wz()));
    }
}
