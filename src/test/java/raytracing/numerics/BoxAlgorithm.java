package raytracing.numerics;


/** Ways to meet a box, the simplest first. */
public enum BoxAlgorithm implements Algorithm {
    TEXTBOOK("textbook", "slabs from two corners, products with 1 / d, Math.min and Math.max",
        BoxWitnesses::reciprocal),
    ORDERED("ordered", "the same with ordered comparisons, which drop a NaN", BoxWitnesses::reciprocalOrdered),
    DIVISION("division", "slabs from two corners, quotients, a test for d = 0", BoxWitnesses::division),
    COMPENSATED("compensated", "quotients of compensated sums centre - o -/+ half edge", BoxWitnesses::compensated),
    OURS("ours", "Box", ProductAlgorithms.BOX),
    DOUBLE_DOUBLE("double-double", "every operation with 106 bits", BoxWitnesses::doubleDouble);

    private final String title;
    private final String description;
    private final Formula formula;

    BoxAlgorithm(String title, String description, Formula formula) {
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
