package raytracing.report;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.List;
import raytracing.film.Film;

/** The pictures of a family side by side, their errors below, in one picture on white: for documents without styles. */
final class Strip {
    /** Of a picture; one of this size stays as it is. */
    static final int EDGE = 160;

    private static final int GAP = 12;
    private static final int TEXT = 22;
    private static final int BAR = 18;
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 13);

    private final BufferedImage strip;
    private final Graphics2D graphics;

    private Strip(int columns) {
        strip = new BufferedImage(columns * (EDGE + GAP) + GAP, 2 * EDGE + 3 * GAP + 2 * TEXT,
            BufferedImage.TYPE_INT_RGB);
        graphics = strip.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, 0, strip.getWidth(), strip.getHeight());
        graphics.setColor(Ink.TEXT.color());
        graphics.setFont(FONT);
    }

    /** The reference first, with the colours of the errors where the others have theirs. */
    static BufferedImage of(FamilyStudy study, List<Measurement> measurements) {
        Film reference = study.reference().film();
        Strip strip = new Strip(1 + measurements.size());
        strip.picture(0, top(), reference.toImage());
        strip.legend();
        strip.caption(0, "reference", "");
        for (int i = 0; i < measurements.size(); i++) {
            Measurement measurement = measurements.get(i);
            TimedError figures = study.figures(measurement);
            strip.picture(i + 1, top(), measurement.film().toImage());
            strip.picture(i + 1, top() + EDGE + GAP, ErrorMap.of(measurement.film(), reference));
            strip.caption(i + 1, measurement.setting().title(),
                Shown.duration(figures.milliseconds()) + ", error " + Shown.error(figures.error()));
        }
        strip.graphics.dispose();
        return strip.strip;
    }

    private static int top() {
        return GAP;
    }

    private static int left(int column) {
        return GAP + column * (EDGE + GAP);
    }

    /** Pixels stay squares. */
    private void picture(int column, int y, BufferedImage picture) {
        graphics.drawImage(picture, left(column), y, EDGE, EDGE, null);
    }

    private void caption(int column, String first, String second) {
        int y = top() + 2 * EDGE + GAP + TEXT;
        graphics.drawString(first, left(column), y);
        graphics.drawString(second, left(column), y + TEXT);
    }

    private void legend() {
        int y = top() + EDGE + GAP + EDGE / 3;
        graphics.drawImage(ColorScale.legend(EDGE, BAR), left(0), y, null);
        graphics.drawRect(left(0), y, EDGE - 1, BAR - 1);
        graphics.drawString("0.0001", left(0), y + BAR + TEXT);
        graphics.drawString("0.01", left(0) + EDGE / 2 - 13, y + BAR + TEXT);
        graphics.drawString("1", left(0) + EDGE - 9, y + BAR + TEXT);
        graphics.drawString("error, linear light", left(0), y + BAR + 2 * TEXT);
    }
}
