/** What the scene parser owes to any bytes at all, and the inputs that it is held to it with. */
package raytracing.fuzz;
