package raytracing.preview;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import raytracing.render.Cancellation;
import raytracing.render.Region;

@Isolated("changes where all standard errors go")
class PreviewLimitsTest {
    private static final int SIDE = 1 << 13;

    /** One row more than may be shown. */
    @Test
    void tooLargeAPictureIsASentenceAndNoWindow() {
        ByteArrayOutputStream errors = new ByteArrayOutputStream();
        PrintStream before = System.err;
        System.setErr(new PrintStream(errors, true, StandardCharsets.UTF_8));
        try {
            assertEquals(Optional.empty(), Preview.open("out.png", new Region(5, 0, 5 + SIDE, SIDE + 1), new Cancellation(),
                Optional.of(new Thread("not begun"))));
        } finally {
            System.setErr(before);
        }
        assertEquals("--preview: pictures of more than 67108864 pixels are not shown; drawing goes on without it"
            + System.lineSeparator(), errors.toString(StandardCharsets.UTF_8));
    }
}
