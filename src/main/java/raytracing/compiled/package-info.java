/** A scene made ready for many rays: flat arrays, one for each kind of surface; the camera's frame worked out. */
package raytracing.compiled;
