package raytracing;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.core.importer.Location;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.CompositeArchRule;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** Packages are rooms, and imports go one way: each room knows only those before it in this list. */
@AnalyzeClasses(packages = "raytracing", importOptions = RoomsTest.TheProgramAlone.class)
class RoomsTest {
    /** The tests, the benchmarks and the report have no rooms; they lie beside the program when tests run. */
    static final class TheProgramAlone implements ImportOption {
        @Override
        public boolean includes(Location location) {
            return location.contains("/classes/java/main/");
        }
    }

    private static final List<String> ROOMS = List.of("progress", "math", "area", "color", "geometry", "scene", "parse", "compiled",
        "shade", "film", "render", "command", "watch");

    @ArchTest
    static final ArchRule everyClassLivesInARoomOrAtTheFrontDoor = classes().should().resideInAnyPackage(
        ROOMS.stream().map(room -> "raytracing." + room).toArray(String[]::new))
        .orShould().haveFullyQualifiedName("raytracing.RayTracer");

    @ArchTest
    static final ArchRule importsGoOneWay = importsGoOneWay();

    private static ArchRule importsGoOneWay() {
        List<ArchRule> rules = new ArrayList<>();
        for (int i = 0; i < ROOMS.size(); i++) {
            List<String> later = new ArrayList<>(List.of("raytracing"));
            ROOMS.subList(i + 1, ROOMS.size()).forEach(room -> later.add("raytracing." + room));
            rules.add(forbidden(ROOMS.get(i), later.toArray(String[]::new)));
        }
        return CompositeArchRule.of(rules);
    }

    private static ArchRule forbidden(String room, String... packages) {
        return noClasses().that().resideInAPackage("raytracing." + room)
            .should().dependOnClassesThat().resideInAnyPackage(packages);
    }

    @ArchTest
    static final ArchRule geometryKnowsNoColours = forbidden("geometry", "raytracing.color");

    @ArchTest
    static final ArchRule filmKnowsOnlyColours = forbidden("film", "raytracing.math", "raytracing.geometry",
        "raytracing.scene", "raytracing.parse", "raytracing.compiled", "raytracing.shade");

    @ArchTest
    static final ArchRule onlyTheFilmWritesPictures = noClasses().that().resideOutsideOfPackage("raytracing.film")
        .should().dependOnClassesThat().resideInAnyPackage("javax.imageio..");

    @ArchTest
    static final ArchRule onlyTheFilmAndTheWatchKnowImages = noClasses()
        .that().resideOutsideOfPackages("raytracing.film", "raytracing.watch")
        .should().dependOnClassesThat().resideInAnyPackage("java.awt..", "javax.swing..");

    /** A unit of time is no work. */
    @ArchTest
    static final ArchRule onlyRenderSharesWork = noClasses().that().resideOutsideOfPackage("raytracing.render")
        .should().dependOnClassesThat(JavaClass.Predicates.resideInAPackage("java.util.concurrent..")
            .and(DescribedPredicate.not(JavaClass.Predicates.equivalentTo(TimeUnit.class))));

    /**
     * The film's thread only loads the encoder's classes while something else is done; those of the watch tell of the
     * work and end it, and do none.
     */
    @ArchTest
    static final ArchRule onlyRenderFilmAndWatchStartThreads = noClasses()
        .that().resideOutsideOfPackages("raytracing.render", "raytracing.film", "raytracing.watch")
        .should().dependOnClassesThat().haveFullyQualifiedName("java.lang.Thread");

    /** Math.sin, pow and the like may differ between machines; sqrt, fma, abs and the exact ones may not. */
    @ArchTest
    static final ArchRule pixelsDependOnNoFunctionThatDiffersBetweenMachines = noClasses().should()
        .callMethodWhere(DescribedPredicate.describe("Math's inexact functions",
            call -> call.getTargetOwner().isEquivalentTo(Math.class) && List.of("sin", "cos", "tan", "asin", "acos",
                "atan", "atan2", "exp", "expm1", "log", "log10", "log1p", "pow", "cbrt", "hypot", "sinh", "cosh",
                "tanh", "random").contains(call.getName())));
}
