package raytracing.report;

import java.awt.Font;
import java.awt.font.FontRenderContext;
import java.awt.font.TextLayout;
import raytracing.parse.RayTracerException;

/** Plots have text in them, and Java has no font of its own. */
final class Fonts {
    private Fonts() {
    }

    /** Better a sentence before minutes of measuring than a stack trace after them. */
    static void check() throws RayTracerException {
        try {
            new TextLayout("1", new Font(Font.SANS_SERIF, Font.PLAIN, 12), new FontRenderContext(null, true, true));
        } catch (RuntimeException | Error noFonts) {   // which one depends on the Java and on what is missing
            throw new RayTracerException("the plots need a font, and Java finds none here; "
                + "apt-get install -y fontconfig fonts-dejavu-core brings some");
        }
    }
}
