/** How far the work on a picture is before the first pixel; knows nothing of the work. */
package raytracing.progress;
