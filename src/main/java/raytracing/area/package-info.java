/** Convex figures in a plane, and their areas in closed form: polygons, and the sections of cones. */
package raytracing.area;
