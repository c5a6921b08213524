/** From a point to a light: how much of what the light sends arrives, through and past the surfaces between them. */
package raytracing.shadow;
