/** What the scene parser must return for any bytes, and the inputs with which that is checked. */
package raytracing.fuzz;
