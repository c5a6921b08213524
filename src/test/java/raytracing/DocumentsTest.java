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
import raytracing.command.CommandLine;
import raytracing.scene.Scene;

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

    @Test
    void theExamplesAreTheSameScene() throws IOException {
        Scene first = example(README);
        assertEquals(first, example(Path.of("src/docs/FORMAT.md")));
        assertEquals(2, first.surfaces().size());
    }

    private static Scene example(Path document) throws IOException {
        MatchResult match = EXAMPLE.matcher(Files.readString(document)).results().findFirst().orElseThrow();
        return SceneText.scene(match.group(1));
    }
}
