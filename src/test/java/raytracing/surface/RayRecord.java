package raytracing.surface;

import raytracing.math.Vector;

/** A {@link Ray} as a value that stays. */
public record RayRecord(Vector origin, double originError, Vector direction, int surfaceLeft, Departure departure) {
    /** A ray from a point that the scene names, such as the camera's position. */
    public RayRecord(Vector origin, Vector direction) {
        this(origin, PointError.written(origin), direction, RayOrigin.NO_SURFACE, Departure.ELSEWHERE);
    }

    public static RayRecord of(Ray ray) {
        return new RayRecord(ray.origin.point(), ray.origin.error, ray.direction(), ray.origin.surface, ray.origin.side);
    }

    /** Makes a ray this one. */
    public void writeTo(Ray ray) {
        RayOrigin start = new RayOrigin();
        start.set(origin.x(), origin.y(), origin.z(), originError, surfaceLeft, departure);
        ray.leave(start, direction.x(), direction.y(), direction.z());
    }

    public Ray toRay() {
        Ray ray = new Ray();
        writeTo(ray);
        return ray;
    }
}
