/** Surfaces, and everything about one surface and a ray: by doubles where a bound on their error lets them decide,
    else exactly. */
package raytracing.surface;
