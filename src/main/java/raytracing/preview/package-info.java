/** The window that shows a picture while it is drawn. */
package raytracing.preview;
