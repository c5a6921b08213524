/** What light does at a surface: Phong's model, mirrors, transparency, soft shadows. A pure function of scene, ray and key. */
package raytracing.shade;
