package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.program.CommandLine;

/** The files, scenes, options, tasks, packages and messages that the documents name exist. */
class DocumentsTest {
    private static final Path README = Path.of("README.md");
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#]+)\\)");
    private static final Pattern OPTION = Pattern.compile("--[a-z-]+");
    private static final Pattern SCENE = Pattern.compile("scenes/\\w+\\.txt");
    private static final Pattern GRADLE_TASK = Pattern.compile("`gradle (\\w+)");
    private static final Pattern TASK_OF_THE_BUILD =
        Pattern.compile("(?:tasks\\.create|measuring|report)\\(\\s*'(\\w+)'");
    private static final List<String> TASKS_OF_GRADLE = List.of("check", "clean", "cleanTest", "jar", "javadoc", "test");

    /** The first cell of a row of README's table of what may go wrong. */
    private static final Pattern TROUBLE = Pattern.compile("(?m)^\\| ([^|]*) \\|");
    private static final Pattern QUOTE = Pattern.compile("`([^`]+)`");
    private static final List<String> SAID_BY_JAVA = List.of("Unable to access jarfile", "UnsupportedClassVersionError",
        "class file version 61.0", "no main manifest attribute");
    private static final Pattern EXAMPLE = Pattern.compile("```\\R(# A red ball.*?)```", Pattern.DOTALL);

    static Stream<Path> documents() throws IOException {
        try (Stream<Path> docs = Files.list(Path.of("src/docs"))) {
            List<Path> markdown = docs.filter(file -> file.toString().endsWith(".md")).toList();
            return Stream.concat(Stream.of(README), markdown.stream());
        }
    }

    @ParameterizedTest
    @MethodSource("documents")
    void linksLeadSomewhere(Path document) throws IOException {
        List<String> dead = LINK.matcher(Files.readString(document)).results().map(match -> match.group(1))
            .filter(target -> !Files.exists(document.toAbsolutePath().resolveSibling(target))).toList();
        assertEquals(List.of(), dead);
    }

    @Test
    void everySceneIsInTheReadme() throws IOException {
        String readme = Files.readString(README);
        for (Path scene : CommittedScenesTest.scenes().toList()) {
            assertTrue(readme.contains("(" + scene.toString().replace('\\', '/') + ")"), scene::toString);
        }
    }

    @Test
    void theReadmeHasTheOptionsOfTheHelp() throws IOException {
        String readme = Files.readString(README);
        for (MatchResult option : OPTION.matcher(CommandLine.HELP).results().toList()) {
            assertTrue(readme.contains("`" + option.group()), option::group);
        }
    }

    @ParameterizedTest
    @MethodSource("documents")
    void tasksOfTheBuildAreThere(Path document) throws IOException {
        Set<String> tasks = new HashSet<>(TASKS_OF_GRADLE);
        TASK_OF_THE_BUILD.matcher(Files.readString(Path.of("build.gradle"))).results()
            .forEach(match -> tasks.add(match.group(1)));
        List<String> missing = GRADLE_TASK.matcher(Files.readString(document)).results().map(match -> match.group(1))
            .filter(task -> !tasks.contains(task)).toList();
        assertEquals(List.of(), missing);
    }

    @Test
    void everyPackageIsInTheReadme() throws IOException {
        String readme = Files.readString(README);
        try (Stream<Path> packages = Files.list(Path.of("src/main/java/raytracing")).filter(Files::isDirectory)) {
            assertEquals(List.of(), packages.map(folder -> folder.getFileName().toString())
                .filter(name -> !readme.contains("[`" + name + "`]")).toList());
        }
    }

    /** Every message that README explains is one of the program or of Java. */
    @Test
    void theReadmeExplainsMessagesThatExist() throws IOException {
        String readme = Files.readString(README);
        String table = readme.substring(readme.indexOf("## When something goes wrong"), readme.indexOf("## The pictures"));
        List<String> messages = TROUBLE.matcher(table).results()
            .flatMap(row -> QUOTE.matcher(row.group(1)).results().map(quote -> quote.group(1))).toList();
        assertTrue(messages.size() >= 10, messages::toString);
        String program = literals();
        assertEquals(List.of(), messages.stream()
            .filter(message -> !SAID_BY_JAVA.contains(message) && !program.contains(message)).toList());
    }

    /** The sources of the program, with string literals in one piece where they are concatenated. */
    private static String literals() throws IOException {
        StringBuilder text = new StringBuilder();
        try (Stream<Path> files = Files.walk(Path.of("src/main/java")).filter(file -> file.toString().endsWith(".java"))) {
            for (Path file : files.toList()) {
                text.append(Files.readString(file).replaceAll("\"\\s*\\+\\s*\"", ""));
            }
        }
        return text.toString();
    }

    @Test
    void theExamplesOfTheHelpNameScenesThatAreThere() {
        List<String> scenes = SCENE.matcher(CommandLine.HELP).results().map(MatchResult::group).toList();
        assertEquals(2, scenes.size());
        assertTrue(scenes.stream().allMatch(scene -> Files.exists(Path.of(scene))), scenes::toString);
    }

    @ParameterizedTest
    @ValueSource(strings = {"README.md", "src/docs/FORMAT.md"})
    void theExampleIsTheSceneOfTheBall(Path document) throws IOException {
        MatchResult match = EXAMPLE.matcher(Files.readString(document)).results().findFirst().orElseThrow();
        assertEquals(Files.readString(Path.of("scenes", "ball.txt")), match.group(1));
    }
}
