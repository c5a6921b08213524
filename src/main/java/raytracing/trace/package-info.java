/** A scene made ready for many rays: its surfaces by kind, in hierarchies, and the queries of rays and segments. */
package raytracing.trace;
