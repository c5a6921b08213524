/** Vectors, orthonormal bases and reproducible random numbers; knows nothing of rays, colours or scenes. */
package raytracing.math;
