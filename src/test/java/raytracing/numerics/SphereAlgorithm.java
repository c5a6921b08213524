package raytracing.numerics;


/** Ways to meet a sphere, the simplest first. */
public enum SphereAlgorithm implements Algorithm {
    TEXTBOOK("textbook", "b b - 4 a c as in school", SphereWitnesses::textbook),
    HALF_B("half b", "b b - a c with half the b", SphereWitnesses::halfB),
    CLOSEST_APPROACH("closest approach", "discriminant at the point of closest approach, roots c / q and q / a",
        SphereWitnesses::closestApproach),
    COMPENSATED("compensated c", "the same with c = |o - c|^2 - r^2 from exact differences and products",
        SphereWitnesses::compensated),
    OURS("ours", "Sphere", ProductAlgorithms.SPHERE),
    DOUBLE_DOUBLE("double-double", "every operation with 106 bits", SphereWitnesses::doubleDouble);

    private final String title;
    private final String description;
    private final Formula formula;

    SphereAlgorithm(String title, String description, Formula formula) {
        this.title = title;
        this.description = description;
        this.formula = formula;
    }

    @Override
    public String title() {
        return title;
    }

    @Override
    public String description() {
        return description;
    }

    @Override
    public Formula formula() {
        return formula;
    }
}
