/**
 * Rays and the surfaces they meet: where, and with which normal. One kernel a shape holds its formulas; the
 * objects and the compiled scene both call it. Knows materials only as numbers.
 */
package raytracing.geometry;
