package raytracing.scene;

/** No lens at all: straight lines of the scene stay straight on the screen. */
public record Pinhole() implements Lens {
}
