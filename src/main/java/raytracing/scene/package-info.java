/** The contents of a scene file, checked and immutable: no text, nothing derived, nothing cached. */
package raytracing.scene;
