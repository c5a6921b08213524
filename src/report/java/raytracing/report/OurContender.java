package raytracing.report;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import raytracing.film.Film;
import raytracing.render.Renderer;
import raytracing.render.Renderers;

/** Warm frames of ours, as many as the clock of processor time needs: it ticks a hundred times a second. */
record OurContender(String title, Renderer renderer) implements Contender {
    private static final double NANOSECONDS_IN_MILLISECOND = 1e6;
    private static final double LEAST_MILLISECONDS = 500;
    private static final OperatingSystemMXBean SYSTEM =
        (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();

    @Override
    public Drawn draw() {
        long before = SYSTEM.getProcessCpuTime();
        int frames = 0;
        Film film;
        double milliseconds;
        do {
            film = Renderers.film(renderer);
            frames++;
            milliseconds = (SYSTEM.getProcessCpuTime() - before) / NANOSECONDS_IN_MILLISECOND;
        } while (milliseconds < LEAST_MILLISECONDS);
        return new Drawn(film, milliseconds / frames);
    }
}
