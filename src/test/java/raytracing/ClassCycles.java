package raytracing;

import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Collection;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * Finds groups of top-level classes of one package in which each class depends on every other, directly or through others of
 * the group. Two classes may know each other; three or more that do can only be read, tested and changed together. A nested
 * class is part of its top-level class. That a sealed type knows the types that it permits does not count: Java demands
 * that. A dependency on a constant is not seen: the compiler copies constants.
 */
final class ClassCycles {
    private static final int SMALLEST = 3;

    /** The classes on which each class depends directly. */
    private final Map<String, Set<String>> dependencies = new TreeMap<>();

    /** Reads the dependencies inside a package. */
    ClassCycles(JavaClasses classes, String packageName) {
        for (JavaClass type : classes) {
            if (type.getPackageName().equals(packageName)) {
                Class<?> from = topLevel(type);
                Set<String> targets = dependencies.computeIfAbsent(from.getSimpleName(), name -> new TreeSet<>());
                for (Dependency dependency : type.getDirectDependenciesFromSelf()) {
                    JavaClass target = dependency.getTargetClass().getBaseComponentType();
                    if (target.getPackageName().equals(packageName) && !permits(from, topLevel(target))) {
                        targets.add(topLevel(target).getSimpleName());
                    }
                }
            }
        }
    }

    private static Class<?> topLevel(JavaClass type) {
        Class<?> top = type.reflect();
        while (top.getEnclosingClass() != null) {
            top = top.getEnclosingClass();
        }
        return top;
    }

    private static boolean permits(Class<?> type, Class<?> other) {
        return type.isSealed() && Arrays.stream(type.getPermittedSubclasses())
            .anyMatch(permitted -> permitted == other || permits(permitted, other));
    }

    /** The groups, each as text: one line for every class, with those of the group on which it depends. */
    List<String> groups() {
        Map<String, Set<String>> reachable = new TreeMap<>();
        dependencies.keySet().forEach(node -> reachable.put(node, reachableFrom(node)));
        Collection<Set<String>> groups = dependencies.keySet().stream()
            .map(node -> reachable.get(node).stream().filter(other -> reachable.get(other).contains(node))
                .collect(Collectors.<String, Set<String>>toCollection(TreeSet::new)))
            .filter(group -> group.size() >= SMALLEST).collect(Collectors.toSet());
        return groups.stream().map(this::described).sorted().toList();
    }

    private Set<String> reachableFrom(String start) {
        Set<String> reached = new TreeSet<>();
        Deque<String> open = new ArrayDeque<>(List.of(start));
        while (!open.isEmpty()) {
            for (String target : dependencies.get(open.pop())) {
                if (reached.add(target)) {
                    open.push(target);
                }
            }
        }
        return reached;
    }

    private String described(Set<String> group) {
        return group.stream().map(node -> dependencies.get(node).stream()
                .filter(other -> group.contains(other) && !other.equals(node))
                .collect(Collectors.joining(", ", "    " + node + " -> ", "\n")))
            .collect(Collectors.joining("", group.size() + " classes:\n", ""));
    }
}
