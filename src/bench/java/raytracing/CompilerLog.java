package raytracing;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/**
 * What the compilers of a HotSpot virtual machine did, as its log of {@code -XX:+LogCompilation} says. The log's times have
 * three decimals of a second, so that the time of one short compilation is rough and sums are good.
 *
 * @param compilations that were finished, in the order of the log
 * @param traps places where compiled code gave up and the interpreter took over
 * @param discarded how often compiled code was thrown away, by method
 */
public record CompilerLog(List<Compilation> compilations, List<Trap> traps, Map<String, Integer> discarded) {
    /** The tier of the optimising compiler, C2; tiers 1 to 3 are those of the quick one, C1. */
    public static final int OPTIMISED = 4;

    private static final double MILLISECONDS_IN_SECOND = 1000;

    /** Of the virtual machine's flags, those that make it write this log. */
    static List<String> flags(Path log) {
        return List.of("-XX:+UnlockDiagnosticVMOptions", "-XX:+LogCompilation", "-XX:LogFile=" + log);
    }

    /**
     * One method compiled once.
     *
     * @param method class without its package, a dot, and the method's name
     * @param tier 1 to 4
     * @param milliseconds wall time from the start of the compilation to its end
     * @param bytes of the method's own bytecode
     * @param inlinedBytes bytecode of the methods that were compiled into it
     * @param codeBytes machine code
     * @param inlined bytes of bytecode of each method that was compiled into it, all its copies together
     */
    public record Compilation(String method, int tier, double milliseconds, int bytes, int inlinedBytes, int codeBytes,
                              Map<String, Integer> inlined) {
    }

    /** A place where compiled code gave up: the method in which that was, and the compiler's reason. */
    public record Trap(String method, String reason) {
    }

    /** Reads a log. */
    public static CompilerLog of(Path file) throws IOException {
        try (InputStream bytes = Files.newInputStream(file)) {
            return new Reader(bytes).read();
        } catch (XMLStreamException broken) {
            throw new IOException(file + ": " + broken.getMessage(), broken);
        }
    }

    /** The compilations of some tiers. */
    public List<Compilation> ofTiers(int least, int most) {
        return compilations.stream().filter(c -> c.tier() >= least && c.tier() <= most).toList();
    }

    public static double milliseconds(List<Compilation> some) {
        return some.stream().mapToDouble(Compilation::milliseconds).sum();
    }

    /** One pass over the elements of the log. Numbers of methods and classes are those of the task in which they stand. */
    private static final class Reader {
        private final XMLStreamReader xml;
        private final List<Compilation> compilations = new ArrayList<>();
        private final List<Trap> traps = new ArrayList<>();
        private final List<String> discardedCode = new ArrayList<>();
        private final Map<String, String> methodOfCode = new HashMap<>();
        private final Map<String, String> classes = new HashMap<>();
        private final Map<String, String> methods = new HashMap<>();
        private final Map<String, Integer> sizes = new HashMap<>();
        private final Deque<String> parsed = new ArrayDeque<>();
        private Map<String, Integer> inlined = new TreeMap<>();
        private Map<String, String> task = Map.of();
        private String trapReason = "";

        Reader(InputStream bytes) throws XMLStreamException {
            XMLInputFactory factory = XMLInputFactory.newInstance();
            factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
            xml = factory.createXMLStreamReader(bytes);
        }

        CompilerLog read() throws XMLStreamException {
            while (xml.hasNext()) {
                int event = xml.next();
                if (event == XMLStreamConstants.START_ELEMENT) {
                    start(xml.getLocalName(), attributes());
                } else if (event == XMLStreamConstants.END_ELEMENT && xml.getLocalName().equals("parse")) {
                    parsed.pop();
                }
            }
            // compilers write their part of the log at the end, after what happened to their code
            Map<String, Integer> discarded = new TreeMap<>();
            discardedCode.forEach(id -> discarded.merge(methodOfCode.getOrDefault(id, "?"), 1, Integer::sum));
            return new CompilerLog(compilations, traps, discarded);
        }

        private Map<String, String> attributes() {
            Map<String, String> attributes = new HashMap<>();
            for (int i = 0; i < xml.getAttributeCount(); i++) {
                attributes.put(xml.getAttributeLocalName(i), xml.getAttributeValue(i));
            }
            return attributes;
        }

        private void start(String element, Map<String, String> attributes) {
            switch (element) {
                case "task" -> {
                    task = attributes;
                    inlined = new TreeMap<>();
                    classes.clear();
                    methods.clear();
                    sizes.clear();
                    methodOfCode.put(attributes.get("compile_id"), shortName(attributes.get("method")));
                }
                case "klass" -> classes.put(attributes.get("id"), attributes.get("name"));
                case "method" -> {
                    String holder = classes.getOrDefault(attributes.get("holder"), "?");
                    methods.put(attributes.get("id"), shortName(holder + " " + attributes.get("name")));
                    sizes.put(attributes.get("id"), number(attributes, "bytes"));
                }
                case "parse" -> {
                    String id = attributes.get("method");
                    if (!parsed.isEmpty()) {
                        inlined.merge(methods.getOrDefault(id, "?"), sizes.getOrDefault(id, 0), Integer::sum);
                    }
                    parsed.push(id);
                }
                case "task_done" -> compilations.add(compilation(attributes));
                case "uncommon_trap" -> trapReason = attributes.containsKey("thread") ? attributes.get("reason") : "";
                case "jvms" -> {
                    if (!trapReason.isEmpty()) {
                        traps.add(new Trap(shortName(attributes.get("method")), trapReason));
                        trapReason = "";
                    }
                }
                case "make_not_entrant" -> {
                    if (number(attributes, "level") == OPTIMISED) {
                        discardedCode.add(attributes.get("compile_id"));
                    }
                }
                default -> {
                    // phases, types and branches: not asked for
                }
            }
        }

        private Compilation compilation(Map<String, String> end) {
            double seconds = Double.parseDouble(end.get("stamp")) - Double.parseDouble(task.get("stamp"));
            return new Compilation(shortName(task.get("method")), task.containsKey("level") ? number(task, "level") : OPTIMISED,
                MILLISECONDS_IN_SECOND * seconds, number(task, "bytes"), number(end, "inlined_bytes"), number(end, "nmsize"),
                inlined);
        }

        private static int number(Map<String, String> attributes, String name) {
            return Integer.parseInt(attributes.getOrDefault(name, "0"));
        }

        /** Of "package.Class name signature", Class.name. */
        private static String shortName(String method) {
            String[] parts = method.split(" ");
            return parts[0].substring(parts[0].lastIndexOf('.') + 1) + (parts.length > 1 ? "." + parts[1] : "");
        }
    }
}
