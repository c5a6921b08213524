package raytracing.fuzz;

import com.code_intelligence.jazzer.Jazzer;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import raytracing.SceneFiles;

/**
 * Fuzzes the scene parser with Jazzer: {@code gradle fuzz [-Pminutes=10] [-Pkeep]}. Begins with the corpus and with pieces
 * of the scenes; what fails lies in build/fuzz afterwards. With {@code keep}, the smallest inputs that reach what all
 * reach become the corpus.
 */
public final class Fuzzing {
    private static final Path FOLDER = Path.of("build/fuzz");
    private static final Path FOUND = FOLDER.resolve("found");
    private static final Path SEEDS = FOLDER.resolve("seeds");
    private static final Path MERGED = FOLDER.resolve("merged");
    private static final Path DICTIONARY = Path.of("src/fuzz/dictionary.txt");

    private static final int SECONDS_OF_A_MINUTE = 60;

    /** Bytes: room for a line of every code, several wrong ones, and more mistakes than are listed. */
    private static final int LONGEST_INPUT = 1500;

    private static final int SECONDS_FOR_AN_INPUT = 5;

    /** Of the process that is fuzzed: what it keeps for itself comes on top. */
    private static final String HEAP = "512m";

    private Fuzzing() {
    }

    /**
     * Fuzzes.
     *
     * @param arguments minutes; then "keep" or nothing
     * @throws IOException if a file cannot be read or written
     * @throws InterruptedException if somebody does not want to wait for the end
     */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        emptyFolder(SEEDS);
        Files.createDirectories(FOUND);
        writeSeeds();
        long seconds = Math.round(SECONDS_OF_A_MINUTE * Double.parseDouble(arguments[0]));
        run("-max_total_time=" + seconds, "-timeout=" + SECONDS_FOR_AN_INPUT, "-dict=" + DICTIONARY,
            "-print_final_stats=1", FOUND.toString(), SEEDS.toString());
        if (List.of(arguments).contains("keep")) {
            emptyFolder(MERGED);
            run("-merge=1", MERGED.toString(), FOUND.toString(), SEEDS.toString());
            Corpus.keep(contents(MERGED));
        }
    }

    /** In a process of its own: libFuzzer ends the one that it runs in. */
    private static void run(String... options) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-Xmx" + HEAP, "-cp", System.getProperty("java.class.path"), Jazzer.class.getName(),
            "--target_class=" + ParserFuzzer.class.getName(),
            "--instrumentation_includes=raytracing.parse.**:raytracing.scene.**",
            "-max_len=" + LONGEST_INPUT, "-artifact_prefix=" + FOLDER + "/"));
        command.addAll(List.of(options));
        int status = new ProcessBuilder(command).inheritIO().start().waitFor();
        if (status != 0) {
            throw new IllegalStateException("the fuzzer ended with status " + status + "; what failed is in " + FOLDER);
        }
    }

    private static void writeSeeds() throws IOException {
        List<byte[]> seeds = new ArrayList<>(Corpus.inputs());
        for (Path scene : SceneFiles.all().toList()) {
            seeds.add(firstOfEachCode(Files.readAllLines(scene)).getBytes(StandardCharsets.UTF_8));
        }
        for (int i = 0; i < seeds.size(); i++) {
            Files.write(SEEDS.resolve(Integer.toString(i)), seeds.get(i));
        }
    }

    /** A scene of all codes, and short: what is long is mutated less often. */
    private static String firstOfEachCode(List<String> lines) {
        Set<String> codes = new HashSet<>();
        StringBuilder shortened = new StringBuilder();
        for (String line : lines) {
            if (codes.add(line.split("\\s+", 2)[0])) {
                shortened.append(line).append('\n');
            }
        }
        return shortened.toString();
    }

    /** The shortest first. */
    private static List<byte[]> contents(Path folder) throws IOException {
        List<byte[]> contents = new ArrayList<>();
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.sorted().toList()) {
                contents.add(Files.readAllBytes(file));
            }
        }
        contents.sort(Comparator.comparingInt(bytes -> bytes.length));
        return contents;
    }

    private static void emptyFolder(Path folder) throws IOException {
        Files.createDirectories(folder);
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.toList()) {
                Files.delete(file);
            }
        }
    }
}
