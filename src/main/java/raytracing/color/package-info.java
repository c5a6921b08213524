/** Colours, kept apart from vectors so that no point is ever lit and no light is ever crossed. */
package raytracing.color;
