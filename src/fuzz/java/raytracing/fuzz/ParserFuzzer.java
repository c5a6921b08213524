package raytracing.fuzz;

/** Where the fuzzer enters: it makes up bytes, guided by which branches of the parser they reach. */
public final class ParserFuzzer {
    private ParserFuzzer() {
    }

    /**
     * Tries one input.
     *
     * @param bytes made up by the fuzzer, which looks for this method by its name
     */
    public static void fuzzerTestOneInput(byte[] bytes) {
        AnyBytes.check(bytes);
    }
}
