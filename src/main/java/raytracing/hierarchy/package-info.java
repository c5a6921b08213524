/** Boxes around boxes around bodies, to find the few bodies that a ray, a pyramid or a point may meet; knows only numbers. */
package raytracing.hierarchy;
