package raytracing;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.CompositeArchRule;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** Packages are rooms, and imports go one way: each room knows only those before it in the list. */
@AnalyzeClasses(packages = "raytracing", importOptions = TheProgramAlone.class)
class RoomsTest {
    private static final List<String> ROOMS = List.of("parallel", "math", "color", "area", "hierarchy", "surface", "scene",
        "parse", "trace", "outline", "shadow", "ambient", "shade", "estimate", "film", "render", "preview",
        "program");

    private static String[] packages(List<String> rooms) {
        return rooms.stream().map(room -> "raytracing." + room).toArray(String[]::new);
    }

    private static String[] packages(String... rooms) {
        return packages(List.of(rooms));
    }

    @ArchTest
    static final ArchRule everyClassIsInARoomOrIsTheMainClass = classes().should().resideInAnyPackage(packages(ROOMS))
        .orShould().haveFullyQualifiedName("raytracing.RayTracer");

    @ArchTest
    static final ArchRule importsGoOneWay = importsGoOneWay();

    /** Fails also for a room without classes. */
    private static ArchRule importsGoOneWay() {
        List<ArchRule> rules = new ArrayList<>();
        for (int i = 0; i < ROOMS.size(); i++) {
            rules.add(knowsOnly(ROOMS.get(i), ROOMS.subList(0, i)));
        }
        return CompositeArchRule.of(rules);
    }

    private static ArchRule knowsOnly(String room, List<String> others) {
        List<String> allowed = new ArrayList<>(others);
        allowed.add(room);
        return noClasses().that().resideInAPackage("raytracing." + room)
            .should().dependOnClassesThat(JavaClass.Predicates.resideInAPackage("raytracing..")
                .and(DescribedPredicate.not(JavaClass.Predicates.resideInAnyPackage(packages(allowed)))))
            .as(room + " knows only " + others);
    }

    @ArchTest
    static final ArchRule surfacesKnowOnlyNumbersAndBounds = knowsOnly("surface", List.of("math", "hierarchy"));

    @ArchTest
    static final ArchRule theHierarchyKnowsOnlyNumbersAndThreads = knowsOnly("hierarchy", List.of("parallel", "math"));

    @ArchTest
    static final ArchRule filmKnowsOnlyColors = knowsOnly("film", List.of("color"));

    @ArchTest
    static void noThreeClassesOfARoomDependOnEachOther(JavaClasses program) {
        StringBuilder cycles = new StringBuilder();
        for (String room : ROOMS) {
            new ClassCycles(program, "raytracing." + room).groups()
                .forEach(group -> cycles.append(room).append(", ").append(group));
        }
        assertEquals("", cycles.toString());
    }

    @ArchTest
    static final ArchRule onlyTheFilmWritesPictures = noClasses().that().resideOutsideOfPackage("raytracing.film")
        .should().dependOnClassesThat().resideInAnyPackage("javax.imageio..");

    @ArchTest
    static final ArchRule onlyTheFilmAndThePreviewKnowImages = noClasses()
        .that().resideOutsideOfPackages(packages("film", "preview"))
        .should().dependOnClassesThat().resideInAnyPackage("java.awt..", "javax.swing..");

    /** A unit of time shares no work. */
    @ArchTest
    static final ArchRule onlyParallelAndRenderShareWork = noClasses()
        .that().resideOutsideOfPackages(packages("parallel", "render"))
        .should().dependOnClassesThat(JavaClass.Predicates.resideInAPackage("java.util.concurrent..")
            .and(DescribedPredicate.not(JavaClass.Predicates.equivalentTo(TimeUnit.class))));

    /**
     * The film's thread only loads the encoder's classes while something else is done; those of the program report and cancel
     * the work, and the preview only waits for the film's.
     */
    @ArchTest
    static final ArchRule onlyTheseRoomsStartThreads = noClasses()
        .that().resideOutsideOfPackages(packages("parallel", "film", "preview", "program"))
        .should().dependOnClassesThat().haveFullyQualifiedName("java.lang.Thread");

    /** Math.sin, pow and the like may differ between machines; sqrt, fma, abs and the exact ones may not. */
    @ArchTest
    static final ArchRule pixelsDependOnNoFunctionThatDiffersBetweenMachines = noClasses().should()
        .callMethodWhere(DescribedPredicate.describe("Math's inexact functions",
            call -> call.getTargetOwner().isEquivalentTo(Math.class) && List.of("sin", "cos", "tan", "asin", "acos",
                "atan", "atan2", "exp", "expm1", "log", "log10", "log1p", "pow", "cbrt", "hypot", "sinh", "cosh",
                "tanh", "random").contains(call.getName())));

    /** Math.fma is computed in decimals where the processor has no such operation. */
    @ArchTest
    static final ArchRule fusedAloneCallsFma = noClasses().that().doNotHaveSimpleName("Fused").should()
        .callMethodWhere(DescribedPredicate.describe("Math.fma",
            call -> call.getTargetOwner().isEquivalentTo(Math.class) && call.getName().equals("fma")));
}
