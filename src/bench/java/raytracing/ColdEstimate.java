package raytracing;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import raytracing.parse.RayTracerException;
import raytracing.render.RenderSettings;
import raytracing.render.Renderers;
import raytracing.scene.Scene;

/** How long a scene takes to be made ready in a virtual machine that has done nothing yet but read it. */
public final class ColdEstimate {
    private static final double NANOSECONDS_IN_SECOND = 1e9;

    private ColdEstimate() {
    }

    /**
     * Prints the seconds.
     *
     * @param arguments the scene file
     */
    public static void main(String[] arguments) throws IOException, RayTracerException {
        Scene scene = Steps.parseScene(Path.of(arguments[0]));
        long start = System.nanoTime();
        Renderers.of(scene, RenderSettings.DEFAULT);
        System.out.println((System.nanoTime() - start) / NANOSECONDS_IN_SECOND);
    }

    /** Runs {@link #main} in a virtual machine of its own. */
    static double seconds(Path scene) throws IOException {
        Process process = new ProcessBuilder(MeasuredProcess.java("-cp", System.getProperty("java.class.path"),
            ColdEstimate.class.getName(), scene.toString())).start();
        return Double.parseDouble(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8));
    }
}
