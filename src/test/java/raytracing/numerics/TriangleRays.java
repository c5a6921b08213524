package raytracing.numerics;

/**
 * Judges very many rays at triangles: {@code gradle triangleRays [-Prays=1000000] [-Pseed=1]}. Prints a row for each family,
 * and fails if an answer is wrong.
 */
public final class TriangleRays {
    private TriangleRays() {
    }

    /**
     * Judges them.
     *
     * @param arguments how many rays in all; the seed
     */
    public static void main(String[] arguments) {
        int families = TriangleFamily.values().length;
        int each = (Integer.parseInt(arguments[0]) + families - 1) / families;
        long seed = Long.parseLong(arguments[1]);
        System.out.println("| rays at triangles | rays | hits, % | left to exact numbers, % | worst error, u | wrong |");
        System.out.println("|---|---:|---:|---:|---:|---:|");
        int wrong = 0;
        for (TriangleFamily family : TriangleFamily.values()) {
            TriangleVerdict verdict = TriangleVerdict.of(family, seed, each);
            System.out.println(verdict.row(family.title()));
            verdict.faults().stream().limit(3).forEach(System.out::println);
            wrong += verdict.faults().size();
        }
        if (wrong > 0) {
            throw new IllegalStateException(wrong + " wrong answers");
        }
    }
}
