/** What a scene file says, checked and immutable: no text, nothing derived, nothing cached. */
package raytracing.scene;
