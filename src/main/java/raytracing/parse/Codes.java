package raytracing.parse;

/** The codes of a scene file, as {@link SceneText#code} packs them. */
final class Codes {
    static final int CAM = 'c' << 16 | 'a' << 8 | 'm';
    static final int SET = 's' << 16 | 'e' << 8 | 't';
    static final int MTL = 'm' << 16 | 't' << 8 | 'l';
    static final int SPH = 's' << 16 | 'p' << 8 | 'h';
    static final int PLN = 'p' << 16 | 'l' << 8 | 'n';
    static final int BOX = 'b' << 16 | 'o' << 8 | 'x';
    static final int LGT = 'l' << 16 | 'g' << 8 | 't';

    private Codes() {
    }
}
