package raytracing.scene;

/** How the camera bends light between the scene and the screen. */
public sealed interface Lens permits Pinhole, Fisheye {
}
