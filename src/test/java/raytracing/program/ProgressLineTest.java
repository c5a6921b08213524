package raytracing.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import org.junit.jupiter.api.Test;
import raytracing.SceneText;
import raytracing.parallel.Preparation;
import raytracing.render.Cancellation;
import raytracing.render.Drawing;
import raytracing.render.DrawingListener;
import raytracing.render.RenderSettings;
import raytracing.render.Renderer;
import raytracing.render.Renderers;

/** What the line says. That it is written over and over is seen on terminals. */
class ProgressLineTest {
    private static final long SECOND = 1_000_000_000;
    private static final long START = 7 * SECOND;

    private final ByteArrayOutputStream written = new ByteArrayOutputStream();
    private final Preparation preparation = new Preparation();
    private final ProgressLine line = line("out.png");

    private ProgressLine line(String name) {
        return new ProgressLine(new PrintStream(written), name, preparation, START);
    }

    @Test
    void readingIsSaidBeforeItsShareIsKnown() {
        assertEquals("out.png  reading  0:03 elapsed", line.text(START + 3 * SECOND));
    }

    @Test
    void theShareThatIsReadIsInWholePercents() {
        preparation.expect(1000);
        preparation.advance(379);
        assertEquals("out.png  reading  37 %  0:01 elapsed", line.text(START + SECOND));
    }

    @Test
    void arrangingComesNext() {
        preparation.begin(Preparation.Step.ARRANGING);
        assertEquals("out.png  arranging  0:04 elapsed", line.text(START + 4 * SECOND));
        preparation.expect(600_000);
        preparation.advance(300_000);
        assertEquals("out.png  arranging  50 %  0:05 elapsed", line.text(START + 5 * SECOND));
    }

    @Test
    void ambientLightComesAfterThat() {
        preparation.begin(Preparation.Step.AMBIENT_LIGHT);
        preparation.expect(1600);
        preparation.advance(400);
        assertEquals("out.png  ambient light  25 %  1:00 elapsed", line.text(START + 60 * SECOND));
    }

    /** The time that is left counts from the first pixel, not from the start of the program. */
    @Test
    void theDrawingHasATimeThatIsLeft() {
        RenderSettings settings = RenderSettings.DEFAULT.withSize(20, 20);
        Renderer renderer = Renderers.of(SceneText.scene("cam 0 0 -3  0 0 0  0 1 0  1 1", "set 0 0 0  1 1"), settings);
        Drawing drawing =
            new Drawing(renderer, new Cancellation(), Cancellation.Leftovers.DISCARD, DrawingListener.NONE);
        line.follow(drawing);
        assertEquals("out.png  0 %  0:02 elapsed", line.text(START + 2 * SECOND));
        drawing.band(0);
        assertEquals("out.png  100 %  0:09 elapsed  0:00 left", line.text(START + 9 * SECOND));
    }

    @Test
    void aLongNameLeavesRoomForTheRest() {
        preparation.begin(Preparation.Step.AMBIENT_LIGHT);
        preparation.expect(1);
        preparation.advance(1);
        String text = line("x".repeat(100) + ".png").text(START + 36_000 * SECOND);
        assertTrue(text.endsWith("x.png  ambient light  100 %  10:00:00 elapsed") && text.length() < 80, text);
    }

    @Test
    void whatWasNeverShownNeedsNotBeTakenAway() {
        line.end();
        line.end();
        assertEquals("", written.toString());
    }
}
