package raytracing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/**
 * HotSpot compiles a hot method again into each of its callers, unless its bytecode is longer than 325 bytes
 * ({@code FreqInlineSize}). In a chain of short methods the innermost one is compiled many times, each time with all that is
 * inlined into it, and a picture that takes a second waits for that. So some methods are longer on purpose. No other method of
 * these rooms may be: if a small one grows beyond the limit, it becomes a call inside a loop, and no other test notices.
 */
class LongMethodsTest {
    private static final int LONGEST_INLINED = 325;

    private static final Path CLASSES = Path.of("build", "classes", "java", "main", "raytracing");
    private static final List<String> HOT_ROOMS = List.of("area", "hierarchy", "surface", "trace", "shadow", "shade");

    /** The methods that are long, and why. */
    private static final Map<String, String> LONG = new TreeMap<>(Map.ofEntries(
        // on purpose: most of the work on a ray or a shadow is inlined into each of these, and would be again into its callers
        Map.entry("RayTraversal.nextLeaf", "a way down a hierarchy"),
        Map.entry("PyramidTraversal.isOutside", "a box and a shaft"),
        Map.entry("Shader.follow", "one straight ray"),
        Map.entry("Shader.addDirectLight", "the light of all lamps at one point"),
        Map.entry("RayQuery.advance", "one step of a ray"),
        Map.entry("ShaftQuery.aim", "all surfaces sorted for one light and point"),
        Map.entry("ShaftQuery.findTransmittances", "up to 64 lines to one light"),
        Map.entry("SphereObstacles$SphereObstacle.dim", "the same past one sphere"),
        Map.entry("ExactShadows.meanTransmittance", "one exact shadow"),
        Map.entry("ConvexShadows.lightPastFigure", "recursive with others, which would be inlined in each other"),
        // in one piece for readers: a call is short beside what these do
        Map.entry("Sphere.compensatedCrossing", "a grazing ray in pairs of doubles"),
        Map.entry("Sphere.compensatedDiscriminant", "the same for a shadow ray"),
        Map.entry("Shaft.aim", "once for each light and point"),
        Map.entry("SphereObstacles.sort", "once for each light and point, all spheres"),
        Map.entry("PlaneObstacles.sort", "once for each light and point, all planes"),
        Map.entry("BoxObstacles.sort", "once for each light and point, all boxes"),
        Map.entry("Triangle.passing", "a line and a triangle"),
        Map.entry("TriangleObstacles.isBesideAxis", "once for each triangle whose box reaches into a shaft"),
        Map.entry("TriangleObstacles.look", "once for each light and point near a triangle"),
        Map.entry("BallShadow.set", "once for each exact shadow of a sphere"),
        Map.entry("Conic.area", "an integral"),
        Map.entry("Conic.addArc", "a part of it")));

    @Test
    void onlyTheMethodsThatShouldBeLongAreLong() throws IOException {
        Map<String, Integer> sizes = new TreeMap<>();
        for (String room : HOT_ROOMS) {
            sizes.putAll(sizes(CLASSES.resolve(room)));
        }
        Map<String, Integer> found = new TreeMap<>(sizes);
        found.values().removeIf(size -> size <= LONGEST_INLINED);
        found.keySet().removeIf(name -> name.contains("<"));   // constructors, which run once
        assertEquals(LONG.keySet(), found.keySet(), () -> "bytes of bytecode: " + found);
    }

    /** Bytes of bytecode of every method in a folder of class files, the largest of those with the same name. */
    private static Map<String, Integer> sizes(Path folder) throws IOException {
        Map<String, Integer> sizes = new TreeMap<>();
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.filter(path -> path.toString().endsWith(".class")).toList()) {
                ClassReader reader = new ClassReader(Files.readAllBytes(file));
                reader.accept(new Sizes(reader, sizes), 0);
            }
        }
        return sizes;
    }

    /** Writes a class again, instruction by instruction, and notes where the code of each method ends. */
    private static final class Sizes extends ClassVisitor {
        private final String className;
        private final Map<String, Integer> sizes;

        /** With the same constants at the same places, so that every instruction keeps its length. */
        Sizes(ClassReader reader, Map<String, Integer> sizes) {
            super(Opcodes.ASM9, new ClassWriter(reader, 0));
            className = reader.getClassName().substring(reader.getClassName().lastIndexOf('/') + 1);
            this.sizes = sizes;
        }

        @Override
        public MethodVisitor visitMethod(int access, String name, String descriptor, String signature, String[] exceptions) {
            return new MethodVisitor(Opcodes.ASM9, super.visitMethod(access, name, descriptor, signature, exceptions)) {
                @Override
                public void visitMaxs(int maxStack, int maxLocals) {
                    Label end = new Label();
                    visitLabel(end);
                    sizes.merge(className + "." + name, end.getOffset(), Math::max);
                    super.visitMaxs(maxStack, maxLocals);
                }
            };
        }
    }
}
