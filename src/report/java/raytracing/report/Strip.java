package raytracing.report;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.List;
import raytracing.film.Film;
import raytracing.render.Region;

/**
 * The pictures of a family side by side, their errors and their worst places below, in one picture on white: for documents
 * without styles.
 */
final class Strip {
    /** Of a picture; larger ones are scaled down. */
    private static final int EDGE = 250;

    /** Of a close-up, two of which stand below a picture. */
    private static final int CLOSEUP = 122;

    private static final int GAP = 12;
    private static final int TEXT = 22;
    private static final int BAR = 18;
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 13);

    private final BufferedImage strip;
    private final Graphics2D graphics;

    private Strip(int columns) {
        strip = new BufferedImage(columns * (EDGE + GAP) + GAP, top(3) - GAP + CLOSEUP - EDGE + 2 * TEXT + GAP,
            BufferedImage.TYPE_INT_RGB);
        graphics = strip.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, 0, strip.getWidth(), strip.getHeight());
        graphics.setColor(Ink.TEXT.color());
        graphics.setFont(FONT);
    }

    /** The whole reference first, with the colours of the errors where the others have theirs. */
    static BufferedImage of(FamilyStudy study, Film reference) {
        List<Measurement> measurements = PictureRow.of(study);
        Strip strip = new Strip(1 + measurements.size());
        strip.picture(0, 0, Illustration.scaled(reference.toImage(), EDGE));
        strip.legend();
        strip.caption(0, "reference", "");
        for (int i = 0; i < measurements.size(); i++) {
            Measurement measurement = measurements.get(i);
            TimedError figures = study.figures(measurement);
            int column = i + 1;
            measurement.illustration().ifPresent(illustration -> strip.draw(column, illustration));
            strip.caption(i + 1, measurement.setting().title(),
                Shown.duration(figures.milliseconds()) + ", error " + Shown.error(figures.error()));
        }
        strip.graphics.dispose();
        return strip.strip;
    }

    private static int top(int row) {
        return GAP + row * (EDGE + GAP);
    }

    private static int left(int column) {
        return GAP + column * (EDGE + GAP);
    }

    /** Pixels stay squares. */
    private void picture(int column, int row, BufferedImage picture) {
        graphics.drawImage(picture, left(column), top(row), EDGE, EDGE, null);
    }

    private void draw(int column, Illustration illustration) {
        picture(column, 0, Illustration.scaled(illustration.picture(), EDGE));
        illustration.errorMap().ifPresent(map -> picture(column, 1, Illustration.scaled(map, EDGE)));
        frame(column, illustration);
        Closeup closeup = illustration.closeup();
        graphics.drawImage(closeup.found().toImage(), left(column), top(2), CLOSEUP, CLOSEUP, null);
        graphics.drawImage(closeup.aim().toImage(), left(column) + EDGE - CLOSEUP, top(2), CLOSEUP, CLOSEUP, null);
    }

    /** Around the place of the close-up, in the map of the errors. */
    private void frame(int column, Illustration illustration) {
        Region place = illustration.closeup().place();
        double scale = (double) EDGE / illustration.pictureSize();
        graphics.drawRect(left(column) + (int) (place.left() * scale) - 1, top(1) + (int) (place.top() * scale) - 1,
            (int) (place.width() * scale) + 1, (int) (place.height() * scale) + 1);
    }

    private void caption(int column, String first, String second) {
        int y = top(2) + CLOSEUP + TEXT;
        graphics.drawString(first, left(column), y);
        graphics.drawString(second, left(column), y + TEXT);
    }

    private void legend() {
        int y = top(1) + EDGE / 3;
        graphics.drawImage(ColorScale.legend(EDGE, BAR), left(0), y, null);
        graphics.drawRect(left(0), y, EDGE - 1, BAR - 1);
        graphics.drawString("0.0001", left(0), y + BAR + TEXT);
        graphics.drawString("0.01", left(0) + EDGE / 2 - 13, y + BAR + TEXT);
        graphics.drawString("1", left(0) + EDGE - 9, y + BAR + TEXT);
        graphics.drawString("error, linear light", left(0), y + BAR + 2 * TEXT);
        graphics.drawString("the worst 32 x 32 pixels, framed", left(0), top(2) + TEXT);
        graphics.drawString("above: left the picture, right the", left(0), top(2) + 2 * TEXT);
        graphics.drawString("reference", left(0), top(2) + 3 * TEXT);
    }
}
