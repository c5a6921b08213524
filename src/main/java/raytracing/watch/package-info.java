/**
 * What the user sees while a picture is drawn and learns about it afterwards: progress, the window, statistics; and the
 * signals that end it. Nothing here can change a pixel.
 */
package raytracing.watch;
