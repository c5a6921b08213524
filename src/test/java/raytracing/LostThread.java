package raytracing;

import java.nio.file.Files;
import java.nio.file.Path;

/** Runs the program beside a thread that fails as soon as the program draws; the scene, a pipe, is written after that. */
final class LostThread {
    private LostThread() {
    }

    public static void main(String[] arguments) {
        Thread lost = new Thread(() -> {
            while (Thread.getDefaultUncaughtExceptionHandler() == null) {
                Thread.onSpinWait();
            }
            throw new IllegalStateException("as expected");
        }, "lost");
        lost.start();
        new Thread(() -> {
            try {
                lost.join();
                Files.writeString(Path.of(arguments[0]), "cam 0 0 -5 0 0 0 0 1 0 1 1\nset 0.25 0.5 1 1 1\n");
            } catch (Exception impossible) {
                throw new AssertionError(impossible);
            }
        }).start();
        RayTracer.main(arguments);
    }
}
