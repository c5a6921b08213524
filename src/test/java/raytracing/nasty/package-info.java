/** Valid scenes with extreme numbers, drawn by the thousand, to see that every pixel is finite light. */
package raytracing.nasty;
