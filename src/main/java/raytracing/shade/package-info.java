/** The light that a surface sends along a ray: Phong's model, mirrors, transparency, shadows and ambient light. */
package raytracing.shade;
