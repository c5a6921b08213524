/** The truth about ambient light, by brute force, and the scenes on which estimates are held to it. */
package raytracing.ambient;
