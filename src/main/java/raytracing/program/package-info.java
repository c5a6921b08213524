/**
 * The program around the picture: command line, messages, progress line, statistics, signals, and the watching of the scene
 * file. Nothing here changes a pixel.
 */
package raytracing.program;
