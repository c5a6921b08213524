/** Scene text in, {@link raytracing.scene.Scene} out, or sentences that say what to mend. */
package raytracing.parse;
