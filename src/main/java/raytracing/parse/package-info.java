/** Scene text in, {@link raytracing.scene.Scene} out, or messages that say what to correct. */
package raytracing.parse;
