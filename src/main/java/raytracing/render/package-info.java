/** Turns pixels into film, tile by tile on all cores. Knows no formula for light or shape. */
package raytracing.render;
