package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaCodeUnit;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Two paragraphs of README follow a ray and a shadow through the program, from method to method. The methods that they name
 * exist, are at most ten, and each may run when one of those before it does.
 */
@AnalyzeClasses(packages = "raytracing", importOptions = TheProgramAlone.class)
class FollowOneRayTest {
    private static final int MOST_METHODS = 10;

    private static final Pattern METHOD = Pattern.compile("`([A-Z]\\w*)\\.(\\w+)(?:\\(\\))?`");

    @ArchTest
    static void theReadmeFollowsARayAndAShadow(JavaClasses program) throws IOException {
        String readme = Files.readString(Path.of("README.md"));
        CallGraph calls = new CallGraph(program);
        assertEquals(List.of(), mistakes(paragraph(readme, "Follow one ray"), calls));
        assertEquals(List.of(), mistakes(paragraph(readme, "Follow one shadow"), calls));
    }

    @ArchTest
    static void mistakesOfAParagraphAreFound(JavaClasses program) {
        CallGraph calls = new CallGraph(program);
        String readme = "### Follow one ray\n\nFirst `RayTracer.main`, then\n`Shader.light`.\n\nThen `Nothing.atAll`.";
        assertEquals(List.of(), mistakes(paragraph(readme, "Follow one ray"), calls));
        assertEquals(List.of("Shader.dark is no method of the program"),
            mistakes("`RayTracer.main`, `Shader.dark`, `Shader.light()`", calls));
        assertEquals(List.of("RayTracer.main is not reached from what stands before it"),
            mistakes("`Shader.light`, `RayTracer.main`", calls));
        assertEquals(List.of("no method"), mistakes("nothing", calls));
        String many = "`RayTracer.main`, ".repeat(11) + "`A.a`, `A.b`, `A.c`, `A.d`, `A.e`, `A.f`, `A.g`, `A.h`, `A.i`";
        assertEquals(9, mistakes(many, calls).size());
        assertEquals("11 methods", mistakes(many + ", `A.j`", calls).get(10));
    }

    /** The text below a heading, up to the next empty line. */
    private static String paragraph(String document, String heading) {
        Matcher matcher = Pattern.compile("^#+ " + heading + "\\R\\R(.+?)(?:\\R\\R|\\z)", Pattern.MULTILINE | Pattern.DOTALL)
            .matcher(document);
        return matcher.find() ? matcher.group(1) : "";
    }

    private static List<String> mistakes(String paragraph, CallGraph calls) {
        List<String> mistakes = new ArrayList<>();
        Set<JavaCodeUnit> reached = calls.reachableFrom(List.of());
        Set<String> names = new LinkedHashSet<>();
        Matcher matcher = METHOD.matcher(paragraph);
        while (matcher.find()) {
            List<JavaCodeUnit> methods = calls.methods(matcher.group(1), matcher.group(2));
            String name = matcher.group(1) + "." + matcher.group(2);
            if (methods.isEmpty()) {
                mistakes.add(name + " is no method of the program");
            } else if (!names.isEmpty() && methods.stream().noneMatch(reached::contains)) {
                mistakes.add(name + " is not reached from what stands before it");
            }
            names.add(name);
            reached.addAll(calls.reachableFrom(methods));
        }
        if (names.isEmpty()) {
            mistakes.add("no method");
        } else if (names.size() > MOST_METHODS) {
            mistakes.add(names.size() + " methods");
        }
        return mistakes;
    }
}
