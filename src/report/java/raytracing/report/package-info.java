/** Draws scenes in every way there is, and sets the time of each way beside its error. */
package raytracing.report;
