package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/** Says how many faults, put into the program one by one, the tests notice, and writes it into MUTATION.md. */
public final class MutationReport {
    private static final Path DOCUMENT = Path.of("src", "docs", "MUTATION.md");

    private MutationReport() {
    }

    /** What became of the faults of a room. A test that does not end has noticed, too. */
    private record Mutants(String room, int all, int noticed, int timedOut, int unreached) {
        private static final int STATUS = 5;

        /** From PIT's table, which has a line for each. */
        static Mutants of(Path folder) throws IOException {
            List<String> states;
            try (Stream<String> lines = Files.lines(folder.resolve("mutations.csv"))) {
                states = lines.map(line -> line.split(",")[STATUS]).toList();
            }
            int survived = count(states, "SURVIVED");
            int unreached = count(states, "NO_COVERAGE");
            return new Mutants("`" + folder.getFileName() + "`", states.size(), states.size() - survived - unreached,
                count(states, "TIMED_OUT"), unreached);
        }

        private static int count(List<String> states, String state) {
            return (int) states.stream().filter(state::equals).count();
        }

        static Mutants of(Collection<Mutants> parts) {
            return parts.stream().reduce(new Mutants("**all**", 0, 0, 0, 0), (a, b) -> new Mutants(a.room,
                a.all + b.all, a.noticed + b.noticed, a.timedOut + b.timedOut, a.unreached + b.unreached));
        }

        List<String> row() {
            return List.of(room, "" + all, "" + noticed, "" + timedOut, "" + (all - noticed - unreached), "" + unreached,
                String.format(Locale.ROOT, "%.1f %%", 100.0 * noticed / all));
        }
    }

    /**
     * Prints, and writes unless told not to.
     *
     * @param arguments a folder for each room with what PIT found; {@code print} instead of writing
     */
    public static void main(String[] arguments) throws IOException {
        List<Mutants> rooms = new ArrayList<>();
        boolean isWritten = true;
        for (String argument : arguments) {
            if (argument.equals("print")) {
                isWritten = false;
            } else {
                rooms.add(Mutants.of(Path.of(argument)));
            }
        }
        rooms.add(Mutants.of(rooms));
        String table = MarkdownTable.of(
            List.of("room", "mutants", "killed", "of these by time", "survived", "not reached", "share killed"),
            rooms.stream().map(Mutants::row).toList());
        System.out.print(table);
        if (isWritten) {
            MeasuredPart.replace(DOCUMENT, Machine.origin("gradle mutation") + "\n\n" + table);
        }
    }
}
