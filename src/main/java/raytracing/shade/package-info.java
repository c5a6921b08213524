/**
 * What light does at a surface: Phong's model, mirrors, transparency, soft shadows, and the room's ambient light. A pure
 * function of scene, ray and key.
 */
package raytracing.shade;
