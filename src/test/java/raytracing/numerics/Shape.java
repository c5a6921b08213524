package raytracing.numerics;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import raytracing.surface.Surface;

/** The three shapes: who competes, on what, and who knows the exact answer. */
public enum Shape {
    SPHERE(SphereAlgorithm.OURS, List.of(SphereAlgorithm.values()), List.of(SphereFamily.values()),
        ExactSphere::chord, ProductAlgorithms::sphere),
    PLANE(PlaneAlgorithm.OURS, List.of(PlaneAlgorithm.values()), List.of(PlaneFamily.values()),
        ExactPlane::chord, ProductAlgorithms::plane),
    BOX(BoxAlgorithm.OURS, List.of(BoxAlgorithm.values()), List.of(BoxFamily.values()),
        ExactBox::chord, ProductAlgorithms::box);

    private final Algorithm ours;
    private final List<Algorithm> algorithms;
    private final List<Family> families;
    private final Function<Query, Optional<ExactChord>> oracle;
    private final Function<Query, Surface> surface;

    Shape(Algorithm ours, List<Algorithm> algorithms, List<Family> families,
          Function<Query, Optional<ExactChord>> oracle, Function<Query, Surface> surface) {
        this.ours = ours;
        this.algorithms = algorithms;
        this.families = families;
        this.oracle = oracle;
        this.surface = surface;
    }

    /** The product's. */
    public Algorithm ours() {
        return ours;
    }

    /** How far a crossing of the product's may be off: the bounds of the tables of exact answers. */
    int allowedUlps() {
        return this == BOX ? 2 : 16;
    }

    /** All contenders, the textbook's first. */
    public List<Algorithm> algorithms() {
        return algorithms;
    }

    /** All families, the ordinary one first. */
    public List<Family> families() {
        return families;
    }

    Algorithm algorithm(String name) {
        return algorithms.stream().filter(algorithm -> algorithm.name().equals(name)).findFirst().orElseThrow();
    }

    Family family(String name) {
        return families.stream().filter(family -> family.name().equals(name)).findFirst().orElseThrow();
    }

    ExactAnswer exactAnswer(Query query) {
        return oracle.apply(query).map(ExactChord::answer).orElse(ExactAnswer.NO_CROSSING);
    }

    /** The product's object for the query's surface. */
    Surface surface(Query query) {
        return surface.apply(query);
    }
}
