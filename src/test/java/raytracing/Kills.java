package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/**
 * What became of the files of programs that were killed by SIGTERM and SIGKILL.
 *
 * @param older files that were as before, with all their bytes
 * @param newer files that had all bytes of the new picture
 * @param withoutJava how many of the programs did not begin: SIGTERM came while Java started, which then failed
 */
record Kills(int older, int newer, int withoutJava) {
    private static final int SIGKILL = 9;
    private static final int SIGTERM = 15;
    private static final String JAVA_FAILED = "Error occurred during initialization of VM";

    /**
     * A floor that a ball in the middle of the lamps shades at random, four rays to each: such noise is drawn in less time than it
     * takes to write, for it cannot be compressed.
     */
    private static final String SCENE = """
        cam 0 2 0   0 0 0   0 0 1   1 1
        set 0.25 0.5 1   2 4
        mtl 0.5 0.5 0.5   0 0 0   0 0 0   1 0
        pln 0 1 0  0  1
        sph 0 9 0  6  1
        lgt 0 9 0   0.3 0.9 0.6   1 1 20
        lgt 0 9 0   0.9 0.4 0.5   1 1 20
        """;
    private static final byte[] OLDER = "older".getBytes();

    /** How many programs were killed. */
    int count() {
        return older + newer;
    }

    /**
     * Kills programs, two at a time, by one signal each: half of them as soon as a file is seen to be written, the others after
     * a random share of the time that they take and a bit more. Whatever happens then, the file must be whole and the exit
     * status a right one.
     */
    static Kills of(Path folder, int count) throws IOException, InterruptedException {
        Files.writeString(folder.resolve("scene.txt"), SCENE);
        long begin = System.nanoTime();
        List<Process> undisturbed = List.of(start(folder, "new"), start(folder, "another"));
        for (Process process : undisturbed) {
            Patience.awaitEnd(process);
        }
        long usual = System.nanoTime() - begin;
        byte[] newPicture = Files.readAllBytes(folder.resolve("new.png"));
        Random random = new Random(7);
        Kills kills = new Kills(0, 0, 0);
        for (int i = 0; i < count; i += 2) {
            Files.write(folder.resolve("term.png"), OLDER);
            Files.write(folder.resolve("kill.png"), OLDER);
            Process term = start(folder, "term");
            Process kill = start(folder, "kill");
            if (i % 4 == 0) {
                Patience.await("file to be written", () -> isWritten(folder));
            } else {
                Thread.sleep((long) (1.2 * random.nextDouble() * usual / 1e6));
            }
            term.destroy();
            kill.destroyForcibly();
            kills = kills.with(folder, "term", Patience.awaitEnd(term), SIGTERM, newPicture)
                .with(folder, "kill", Patience.awaitEnd(kill), SIGKILL, newPicture);
            Shell.run(folder, "rm -f .[!.]*");
        }
        return kills;
    }

    /** Whether there is more in a folder than the older files: a hidden one beside them, or another size. */
    private static boolean isWritten(Path folder) throws IOException {
        return Folders.names(folder).get(0).startsWith(".") || Files.size(folder.resolve("kill.png")) != OLDER.length
            || Files.size(folder.resolve("term.png")) != OLDER.length;
    }

    private static Process start(Path folder, String name) throws IOException {
        Path log = folder.resolve(name + ".log");
        return Program.start(Program.JAVA_HOME, List.of(), folder, log, log, "scene.txt", name + ".png", "400", "400",
            "--threads", "1");
    }

    private Kills with(Path folder, String name, int status, int signal, byte[] newPicture) throws IOException {
        byte[] found = Files.readAllBytes(folder.resolve(name + ".png"));
        String log = Files.readString(folder.resolve(name + ".log"));
        boolean isOlder = Arrays.equals(found, OLDER);
        boolean isWithoutJava = status == 1 && signal == SIGTERM && log.contains(JAVA_FAILED);
        if (!isOlder && !Arrays.equals(found, newPicture)) {
            throw new AssertionError(found.length + " bytes in a file after signal " + signal + ", status " + status);
        }
        if (status != 0 && status != 128 + signal && !isWithoutJava || isWithoutJava && !isOlder) {
            throw new AssertionError("status " + status + " after signal " + signal + ": " + log);
        }
        return new Kills(older + (isOlder ? 1 : 0), newer + (isOlder ? 0 : 1), withoutJava + (isWithoutJava ? 1 : 0));
    }
}
