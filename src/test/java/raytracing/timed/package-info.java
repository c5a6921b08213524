/** Scenes that are made to be timed, the ways to write any scene down, and what is kept of measurements. */
package raytracing.timed;
