package raytracing.scene;

/** No lens: straight lines of the scene are straight on the screen. */
public record Pinhole() implements Lens {
}
