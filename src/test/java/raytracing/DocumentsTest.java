package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import raytracing.command.CommandLine;

/** What the documents say is there, is there. */
class DocumentsTest {
    private static final Path README = Path.of("README.md");
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#]+)\\)");
    private static final Pattern OPTION = Pattern.compile("--[a-z-]+");
    private static final Pattern SCENE = Pattern.compile("scenes/\\w+\\.txt");
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
