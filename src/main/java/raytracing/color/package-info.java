/** Linear light and factors on it, in types of their own, so that a vector cannot be taken for a colour. */
package raytracing.color;
