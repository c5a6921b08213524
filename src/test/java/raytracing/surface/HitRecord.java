package raytracing.surface;

import raytracing.math.Vector;

/** A {@link Hit} and its material as a value that stays, without where it was seen from. */
public record HitRecord(int surface, int material, Vector point, double pointError, Vector normal, Departure side) {
    public static HitRecord of(Hit hit, int material) {
        return new HitRecord(hit.surface(), material, hit.origin().point(), hit.error(),
            new Vector(hit.normalX(), hit.normalY(), hit.normalZ()), hit.side());
    }

    /** Where a ray crosses a surface at a distance that was found before. */
    public static HitRecord at(Surface surface, RayRecord ray, double distance, int number) {
        Hit hit = new Hit();
        surface.describe(ray.toRay(), number, distance, hit);
        return of(hit, surface.material());
    }

    public Hit toHit() {
        Ray ray = leaving(normal).toRay();
        Vector outwards = side == Departure.INWARD ? normal.times(-1) : normal;
        Hit hit = new Hit();
        hit.placeAtOrigin(ray);
        hit.normal.set(outwards.x(), outwards.y(), outwards.z());
        hit.reach(ray, surface, side);
        return hit;
    }

    public Departure departureTowards(double dx, double dy, double dz) {
        return toHit().departureTowards(dx, dy, dz);
    }

    /** A ray that starts here, on the side from which the surface was seen. */
    public RayRecord leaving(Vector direction) {
        return new RayRecord(point, pointError, direction, surface, side);
    }
}
