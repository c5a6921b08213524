/** Threads for work of any kind, and how far a picture is before its first pixel. */
package raytracing.parallel;
