package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * A copy of the Java at hand that lacks a file. All that programs need is linked to, but for what finds the rest by its own
 * place: the launcher, the virtual machine, and the library that loads the one for windows.
 *
 * @param home its folder
 */
record JavaWithout(Path home) implements AutoCloseable {
    /** Makes one in a folder that is not there yet, without a file of Java's own folder. */
    static JavaWithout file(Path missing, Path home) throws IOException {
        Skipped.unless(Files.exists(Path.of("/proc/self/exe")), "Java finds itself in another way here");
        for (String needed : List.of("bin/java", "lib", "conf")) {
            try (Stream<Path> files = Files.walk(Program.JAVA_HOME.resolve(needed))) {
                for (Path file : (Iterable<Path>) files::iterator) {
                    Path copy = home.resolve(Program.JAVA_HOME.relativize(file));
                    if (Files.isDirectory(file)) {
                        Files.createDirectories(copy);
                    } else if (List.of("java", "libjvm.so", "libjli.so",
                        "libawt.so").contains(file.getFileName().toString())) {
                        Files.createDirectories(copy.getParent());
                        Files.copy(file, copy);
                    } else if (!copy.equals(home.resolve(missing))) {
                        Files.createSymbolicLink(copy, file);
                    }
                }
            }
        }
        return new JavaWithout(home);
    }

    /** Takes the links away: JUnit warns of each that it meets. */
    @Override
    public void close() throws IOException {
        try (Stream<Path> files = Files.walk(home)) {
            for (Path link : files.filter(Files::isSymbolicLink).toList()) {
                Files.delete(link);
            }
        }
    }
}
