package raytracing.scene;

/** The lens of the camera. */
public sealed interface Lens permits Pinhole, Fisheye {
}
