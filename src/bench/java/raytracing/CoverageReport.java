package raytracing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Writes into MUTATION.md, and says, which share of the program the tests reach. */
public final class CoverageReport {
    private static final Path DOCUMENT = Path.of("src", "docs", "MUTATION.md");
    private static final String PACKAGE = RayTracer.class.getPackageName();

    private CoverageReport() {
    }

    /** How many lines and branches there are, and how many of them some test went through. */
    private record Coverage(int lines, int linesReached, int branches, int branchesReached) {
        private static final int BRANCHES_MISSED = 5;
        private static final int BRANCHES_REACHED = 6;
        private static final int LINES_MISSED = 7;
        private static final int LINES_REACHED = 8;

        /** Of a class, from the columns of JaCoCo's table. */
        static Coverage of(String[] cells) {
            int linesReached = Integer.parseInt(cells[LINES_REACHED]);
            int branchesReached = Integer.parseInt(cells[BRANCHES_REACHED]);
            return new Coverage(Integer.parseInt(cells[LINES_MISSED]) + linesReached, linesReached,
                Integer.parseInt(cells[BRANCHES_MISSED]) + branchesReached, branchesReached);
        }

        static Coverage of(Collection<Coverage> parts) {
            return parts.stream().reduce(new Coverage(0, 0, 0, 0), Coverage::plus);
        }

        Coverage plus(Coverage other) {
            return new Coverage(lines + other.lines, linesReached + other.linesReached,
                branches + other.branches, branchesReached + other.branchesReached);
        }

        List<String> row(String name) {
            return List.of(name, "" + lines, share(linesReached, lines), "" + branches, share(branchesReached, branches));
        }

        private static String share(int part, int whole) {
            return whole == 0 ? "" : String.format(Locale.ROOT, "%.1f %%", 100.0 * part / whole);
        }
    }

    /**
     * Writes and prints.
     *
     * @param arguments the table that JaCoCo made, comma-separated
     */
    public static void main(String[] arguments) throws IOException {
        Map<String, Coverage> rooms;
        try (Stream<String> lines = Files.lines(Path.of(arguments[0]))) {
            rooms = lines.skip(1).map(line -> line.split(","))
                .collect(Collectors.toMap(cells -> room(cells[1]), Coverage::of, Coverage::plus, TreeMap::new));
        }
        List<List<String>> rows = Stream.concat(
            Stream.of(Coverage.of(rooms.values()).row("**the whole program**")),
            rooms.entrySet().stream().map(room -> room.getValue().row(room.getKey()))).toList();
        String table = MarkdownTable.of(List.of("room", "lines", "reached", "branches", "reached"), rows);
        System.out.print(table);
        MeasuredPart.replace(DOCUMENT, "coverage", table + "\n" + Machine.origin("gradle coverage"));
    }

    private static String room(String packageName) {
        return packageName.equals(PACKAGE) ? "`RayTracer`" : "`" + packageName.substring(PACKAGE.length() + 1) + "`";
    }
}
