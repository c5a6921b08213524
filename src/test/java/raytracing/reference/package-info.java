/** The program's pictures once more, drawn as simply as possible. */
package raytracing.reference;
