/** The picture: linear light in, files out. The only place that clamps, encodes and calls ImageIO. */
package raytracing.film;
