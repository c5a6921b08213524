package raytracing;

import com.tngtech.archunit.core.domain.AccessTarget;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaCodeUnit;
import com.tngtech.archunit.core.domain.JavaConstructor;
import com.tngtech.archunit.core.domain.JavaMember;
import com.tngtech.archunit.core.domain.JavaMethod;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Which methods and constructors of the program may run which others. A call may run every override of the method that it
 * names; what a lambda calls is called by the method around it; an object may be called by the library, through the library's
 * methods that it overrides, once its constructor has run; and a class is initialised by the first use of it.
 */
final class CallGraph {
    private final JavaClasses program;
    private final Map<JavaCodeUnit, Set<JavaCodeUnit>> targets = new HashMap<>();

    /** Reads all calls of the program. */
    CallGraph(JavaClasses program) {
        this.program = program;
        for (JavaClass type : program) {
            for (JavaCodeUnit unit : type.getCodeUnits()) {
                targets.put(unit, targetsOf(unit));
            }
        }
    }

    /** The methods of a class by its simple name; none if there are no such ones. */
    List<JavaCodeUnit> methods(String className, String methodName) {
        List<JavaCodeUnit> found = new ArrayList<>();
        for (JavaCodeUnit unit : targets.keySet()) {
            if (unit.getOwner().getSimpleName().equals(className) && unit.getName().equals(methodName)) {
                found.add(unit);
            }
        }
        return found;
    }

    /** Everything that may run when these do, with themselves. */
    Set<JavaCodeUnit> reachableFrom(Collection<JavaCodeUnit> starts) {
        Set<JavaCodeUnit> reached = new HashSet<>(starts);
        Deque<JavaCodeUnit> open = new ArrayDeque<>(starts);
        while (!open.isEmpty()) {
            for (JavaCodeUnit target : targets.get(open.pop())) {
                if (reached.add(target)) {
                    open.push(target);
                }
            }
        }
        return reached;
    }

    private Set<JavaCodeUnit> targetsOf(JavaCodeUnit unit) {
        Set<JavaCodeUnit> found = new HashSet<>();
        unit.getOwner().getStaticInitializer().ifPresent(found::add);
        if (unit instanceof JavaConstructor) {
            unit.getOwner().getMethods().stream().filter(this::overridesTheLibrary).forEach(found::add);
        }
        for (JavaAccess<?> access : unit.getAccessesFromSelf()) {
            if (isOfTheProgram(access.getTargetOwner())) {
                access.getTargetOwner().getStaticInitializer().ifPresent(found::add);
                if (access.getTarget() instanceof AccessTarget.CodeUnitAccessTarget target) {
                    target.resolveMember().filter(member -> isOfTheProgram(member.getOwner())).ifPresent(member -> {
                        found.add(member);
                        found.addAll(overrides(member));
                    });
                }
            }
        }
        return found;
    }

    /** The methods of the program that override one. */
    List<JavaCodeUnit> overrides(JavaCodeUnit overridden) {
        List<JavaCodeUnit> found = new ArrayList<>();
        if (overridden instanceof JavaMethod) {
            for (JavaClass type : overridden.getOwner().getAllSubclasses()) {
                type.getMethods().stream().filter(method -> hasSameSignature(method, overridden)).forEach(found::add);
            }
        }
        return found;
    }

    private boolean overridesTheLibrary(JavaMethod method) {
        List<JavaClass> parents = new ArrayList<>(method.getOwner().getAllRawSuperclasses());
        parents.addAll(method.getOwner().getAllRawInterfaces());
        return parents.stream().filter(parent -> !isOfTheProgram(parent))
            .flatMap(parent -> parent.getMethods().stream()).anyMatch(other -> hasSameSignature(method, other));
    }

    /** As far as type parameters leave it open. */
    private static boolean hasSameSignature(JavaCodeUnit a, JavaCodeUnit b) {
        return a.getName().equals(b.getName()) && a.getParameters().size() == b.getParameters().size();
    }

    private boolean isOfTheProgram(JavaClass type) {
        return program.contain(type.getName());
    }

    /** A method as documents name it. */
    static String name(JavaMember member) {
        return member.getOwner().getSimpleName() + "." + member.getName();
    }
}
