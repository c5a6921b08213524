package raytracing;

/** Rays that wait to be cast, numbered from 0. */
interface RayCaster {
    /** How far a ray gets before it meets something; infinite if it meets nothing. */
    double nearest(int ray);

    /** Whether any light comes from the ray's target, a lamp or a far point, to where it starts. */
    boolean occluded(int ray);
}
