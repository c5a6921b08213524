package raytracing.numerics;


/** Ways to meet a plane, the simplest first. */
public enum PlaneAlgorithm implements Algorithm {
    TEXTBOOK("textbook", "(c - N.o) / N.d", PlaneWitnesses::textbook),
    FUSED("fused", "the same with fused multiply-adds", PlaneWitnesses::fused),
    OURS("ours", "Plane", ProductAlgorithms.PLANE),
    DOUBLE_DOUBLE("double-double", "every operation with 106 bits", PlaneWitnesses::doubleDouble);

    private final String title;
    private final String description;
    private final Formula formula;

    PlaneAlgorithm(String title, String description, Formula formula) {
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
