/** Scenes that are in order and made to hurt: drawn by the thousand, to see that every pixel is a number. */
package raytracing.nasty;
