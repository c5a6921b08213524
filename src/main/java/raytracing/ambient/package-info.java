/** The ambient light of a room as shading looks it up: irradiance records, and a cache that interpolates between them. */
package raytracing.ambient;
