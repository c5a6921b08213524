package raytracing.parse;

import java.util.Arrays;

/** The code that begins a line: what the values after it are, and how many there may be, in rising order. */
enum Code {
    CAM("position 3, look-at 3, up 3, screen distance, screen width, [fisheye], [k]", 11, 12, 13),
    SET("background 3, shadow ray root, maximum recursion, [ambient scale]", 5, 6),
    MTL("diffuse 3, specular 3, reflection 3, Phong exponent, transparency, [ambient 3]", 11, 14),
    SPH("centre 3, radius, material", 5),
    PLN("normal 3, offset, material", 5),
    BOX("centre 3, edge, material", 5),
    TRG("corners 3 + 3 + 3, material", 10),
    LGT("position 3, colour 3, specular intensity, shadow intensity, width", 9),
    UNKNOWN("");

    private final String values;
    private final int[] counts;

    Code(String values, int... counts) {
        this.values = values;
        this.counts = counts;
    }

    /** The code of three letters in any case, packed into a number, so that recognising it needs no string. */
    static Code of(byte first, byte second, byte third) {
        return switch (lowerCase(first) << 16 | lowerCase(second) << 8 | lowerCase(third)) {
            case 'c' << 16 | 'a' << 8 | 'm' -> CAM;
            case 's' << 16 | 'e' << 8 | 't' -> SET;
            case 'm' << 16 | 't' << 8 | 'l' -> MTL;
            case 's' << 16 | 'p' << 8 | 'h' -> SPH;
            case 'p' << 16 | 'l' << 8 | 'n' -> PLN;
            case 'b' << 16 | 'o' << 8 | 'x' -> BOX;
            case 't' << 16 | 'r' << 8 | 'g' -> TRG;
            case 'l' << 16 | 'g' << 8 | 't' -> LGT;
            default -> UNKNOWN;
        };
    }

    /** Right for letters; another character does not become a letter. */
    private static int lowerCase(byte letter) {
        return (letter | 0x20) & 0xff;
    }

    boolean isSurface() {
        return this == SPH || this == PLN || this == BOX || this == TRG;
    }

    boolean allows(int count) {
        return Arrays.binarySearch(counts, count) >= 0;
    }

    /** The start of the message about a line with another number of values. */
    String expectation() {
        String alternatives = Arrays.toString(counts).replaceAll("[\\[\\]]", "").replaceFirst(", (\\d+)$", " or $1");
        return "expected " + alternatives + " values (" + values + ")";
    }

    int most() {
        return counts[counts.length - 1];
    }
}
