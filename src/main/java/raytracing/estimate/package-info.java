/** Makes the ambient light of a room: random paths of light from points that the camera sees become irradiance records. */
package raytracing.estimate;
