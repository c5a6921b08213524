package raytracing.numerics;

/** A family that looks for the weak places of a kernel: each ray has a surface of its own. */
record Attack(Shape shape, String title, Family.SurfaceSource surface) implements Family {
    @Override
    public String name() {
        return title;
    }

    @Override
    public Recipe recipe() {
        return new Recipe(1, RandomNumbers::line, surface);
    }
}
