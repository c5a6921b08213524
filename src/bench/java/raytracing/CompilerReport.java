package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import raytracing.CompilerLog.Compilation;
import raytracing.CompilerLog.Trap;

/**
 * Draws a scene from a cold start and prints what the virtual machine's compilers did meanwhile: which methods each tier
 * compiled, how often, for how long, what was compiled into what, and where compiled code gave up. With a second jar it prints
 * the sums of both first. The log itself costs some time, and one run differs from the next by a tenth.
 */
public final class CompilerReport {
    private static final int ROWS = 25;

    private CompilerReport() {
    }

    /**
     * The scene's file, then pairs {@code other=FILE} for a second jar, and options of the program.
     *
     * @throws IOException if a process fails or its log cannot be read
     */
    public static void main(String[] arguments) throws IOException {
        List<String> options = Stream.of(arguments).skip(1).filter(word -> !word.startsWith("other=")).toList();
        CompilerLog log = log(MeasuredProcess.JAR, arguments[0], options);
        List<List<String>> tiers = new ArrayList<>(tiers("", log));
        for (String word : arguments) {
            if (word.startsWith("other=")) {
                tiers.addAll(tiers(", " + word.substring("other=".length()), log(Path.of(word.substring("other=".length())), arguments[0], options)));
            }
        }
        System.out.println(MarkdownTable.of(List.of("tiers", "methods", "ms", "bytes", "bytes inlined", "bytes of machine code"),
            tiers));
        System.out.println("The optimising compiler's methods, by time:\n");
        System.out.println(MarkdownTable.of(List.of("method", "times", "ms", "bytes", "bytes inlined", "bytes of machine code"),
            slowest(log)));
        System.out.println("What it compiled into other methods, by bytes:\n");
        System.out.println(MarkdownTable.of(List.of("method", "into methods", "bytes in all"), inlined(log)));
        System.out.println("Where its code gave up, and what was thrown away:\n");
        System.out.println(MarkdownTable.of(List.of("method", "reason", "times"), givenUp(log)));
    }

    private static CompilerLog log(Path jar, String scene, List<String> options) throws IOException {
        Path log = Files.createTempFile("compiler", ".log");
        Path picture = Files.createTempFile("compiler", ".png");
        try {
            List<String> command = new ArrayList<>(MeasuredProcess.java());
            command.addAll(CompilerLog.flags(log));
            command.addAll(List.of("-jar", jar.toString(), scene, picture.toString(), "--quiet"));
            command.addAll(options);
            MeasuredProcess.run(command);
            return CompilerLog.of(log);
        } finally {
            Files.delete(log);
            Files.delete(picture);
        }
    }

    private static List<List<String>> tiers(String whose, CompilerLog log) {
        return List.of(row("1 to 3, quick" + whose, log.ofTiers(1, CompilerLog.OPTIMISED - 1)),
            row("4, optimising" + whose, log.ofTiers(CompilerLog.OPTIMISED, CompilerLog.OPTIMISED)));
    }

    private static List<String> row(String name, List<Compilation> some) {
        return List.of(name, String.valueOf(some.size()), milliseconds(CompilerLog.milliseconds(some)),
            sum(some.stream().map(Compilation::bytes)), sum(some.stream().map(Compilation::inlinedBytes)),
            sum(some.stream().map(Compilation::codeBytes)));
    }

    private static String milliseconds(double milliseconds) {
        return String.format(Locale.ROOT, "%.0f", milliseconds);
    }

    private static String sum(Stream<Integer> numbers) {
        return String.format(Locale.ROOT, "%,d", numbers.mapToInt(Integer::intValue).sum());
    }

    private static List<List<String>> slowest(CompilerLog log) {
        Map<String, List<Compilation>> byMethod = new TreeMap<>();
        for (Compilation c : log.ofTiers(CompilerLog.OPTIMISED, CompilerLog.OPTIMISED)) {
            byMethod.computeIfAbsent(c.method(), name -> new ArrayList<>()).add(c);
        }
        return byMethod.entrySet().stream()
            .sorted(Comparator.comparingDouble(entry -> -CompilerLog.milliseconds(entry.getValue())))
            .limit(ROWS)
            .map(entry -> row(entry.getKey(), entry.getValue()))
            .toList();
    }

    private static List<List<String>> inlined(CompilerLog log) {
        Map<String, Integer> bytes = new TreeMap<>();
        Map<String, Integer> callers = new TreeMap<>();
        for (Compilation c : log.ofTiers(CompilerLog.OPTIMISED, CompilerLog.OPTIMISED)) {
            c.inlined().forEach((method, size) -> {
                bytes.merge(method, size, Integer::sum);
                callers.merge(method, 1, Integer::sum);
            });
        }
        return bytes.entrySet().stream()
            .sorted(Comparator.comparingInt(entry -> -entry.getValue()))
            .limit(ROWS)
            .map(entry -> List.of(entry.getKey(), callers.get(entry.getKey()).toString(), entry.getValue().toString()))
            .toList();
    }

    private static List<List<String>> givenUp(CompilerLog log) {
        Map<Trap, Integer> counts = new TreeMap<>(Comparator.comparing(Trap::method).thenComparing(Trap::reason));
        log.traps().forEach(trap -> counts.merge(trap, 1, Integer::sum));
        log.discarded().forEach((method, times) -> counts.put(new Trap(method, "thrown away"), times));
        return counts.entrySet().stream()
            .map(entry -> List.of(entry.getKey().method(), entry.getKey().reason(), entry.getValue().toString()))
            .toList();
    }
}
