package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaCodeUnit;
import com.tngtech.archunit.core.domain.JavaConstructor;
import com.tngtech.archunit.core.domain.JavaMethod;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.domain.JavaStaticInitializer;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** Every method and constructor of the program may run when the program does: none is there for tests alone. */
@AnalyzeClasses(packages = "raytracing", importOptions = TheProgramAlone.class)
class UnusedCodeTest {
    /** What the program does not call but has, and why. */
    private static final Map<String, String> KEPT = Map.of();

    @ArchTest
    static void theProgramCallsAllItsCode(JavaClasses program) {
        CallGraph calls = new CallGraph(program);
        List<JavaCodeUnit> main = calls.methods("RayTracer", "main");
        assertFalse(main.isEmpty());
        Set<JavaCodeUnit> used = calls.reachableFrom(main);
        Set<String> unused = new TreeSet<>();
        Set<String> kept = new TreeSet<>();
        for (JavaClass type : program) {
            for (JavaCodeUnit unit : type.getCodeUnits()) {
                if (!isUsed(unit, used, calls) && !isMadeByTheCompiler(unit) && !preventsInstances(unit)) {
                    (KEPT.containsKey(CallGraph.name(unit)) ? kept : unused).add(described(unit));
                }
            }
        }
        assertEquals("", String.join("\n", unused));
        assertEquals(KEPT.size(), kept.size(), () -> "exceptions " + KEPT.keySet() + ", needed " + kept);
    }

    /** An abstract method is also used if only overrides of it are called, each by the name of its class. */
    private static boolean isUsed(JavaCodeUnit unit, Set<JavaCodeUnit> used, CallGraph calls) {
        return used.contains(unit) || unit.getModifiers().contains(JavaModifier.ABSTRACT)
            && calls.overrides(unit).stream().anyMatch(used::contains);
    }

    private static String described(JavaCodeUnit unit) {
        return unit.getOwner().getPackageName() + " " + CallGraph.name(unit) + unit.getRawParameterTypes().stream()
            .map(JavaClass::getSimpleName).collect(Collectors.joining(", ", "(", ")"));
    }

    /** Initialisers, bridges, and the methods of every enum and every record; the constructor of a record is no exception. */
    private static boolean isMadeByTheCompiler(JavaCodeUnit unit) {
        JavaClass type = unit.getOwner();
        return unit instanceof JavaStaticInitializer || unit.getModifiers().contains(JavaModifier.SYNTHETIC)
            || type.isEnum() && unit.getModifiers().contains(JavaModifier.STATIC)
                && List.of("values", "valueOf").contains(unit.getName())
            || type.isRecord() && unit instanceof JavaMethod && unit.getParameters().size() <= 1
                && isDeclared(type.reflect(), unit.getName());
    }

    /** Whether a record has a method by its components or as every object. */
    private static boolean isDeclared(Class<?> record, String name) {
        return List.of("equals", "hashCode", "toString").contains(name)
            || Arrays.stream(record.getRecordComponents()).anyMatch(component -> component.getName().equals(name));
    }

    /** The private constructor of a class that has only static methods. */
    private static boolean preventsInstances(JavaCodeUnit unit) {
        return unit instanceof JavaConstructor && unit.getModifiers().contains(JavaModifier.PRIVATE)
            && unit.getParameters().isEmpty() && unit.getOwner().getConstructors().size() == 1;
    }
}
