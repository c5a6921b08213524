package raytracing.report;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Base64;
import javax.imageio.ImageIO;

/** Small pieces of a page. */
final class Html {
    private Html() {
    }

    /** Text that means itself, between tags and in quoted attributes. */
    static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("\"", "&quot;");
    }

    /** A picture that is part of the page. */
    static String picture(BufferedImage picture, String description) throws IOException {
        return "<img src=\"" + dataUri(picture) + "\" alt=\"" + escaped(description) + "\">";
    }

    private static String dataUri(BufferedImage picture) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageIO.write(picture, "png", bytes);
        return "data:image/png;base64," + Base64.getEncoder().encodeToString(bytes.toByteArray());
    }
}
