package raytracing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.WritableRaster;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import raytracing.Films;
import raytracing.PovRay;
import raytracing.film.Film;

class PeersTest {
    private static final Curve.Look LOOK = new Curve.Look(Ink.BLUE, Series.Shape.CIRCLE);

    private static Curve.Point point(double milliseconds, double steps) {
        return new Curve.Point("off by " + steps, Studies.quiet(milliseconds), steps / 255, false);
    }

    /** From 4 steps of error to half a step, each time with half the error of the one before. */
    private static Curve halving(String title, double milliseconds, double factor) {
        return new Curve(title, LOOK, IntStream.rangeClosed(0, 4)
            .mapToObj(i -> point(milliseconds * Math.pow(factor, i), 4 / Math.pow(2, i))).toList());
    }

    private static PeerStudy study() {
        return new PeerStudy(PeerQuestion.SHADOWS, List.of(halving("POV-Ray: slow", 2, 4), halving("POV-Ray: fast", 1, 4)),
            List.of(halving("ours: best", 1, 2)), 1e-5, 1e-5);
    }

    @Test
    void theTraceIsReadFromWhatPovRaySays() {
        assertEquals(OptionalDouble.of(1536), PovRay.traceMilliseconds("""
            Render Time:
              Photon Time:      0 hours  0 minutes  0 seconds (0.010 seconds)
                          using 1 thread(s) with 0.125 CPU-seconds total
              Radiosity Time:   No radiosity
              Trace Time:       0 hours  1 minutes  4 seconds (64.096 seconds)
                          using 2 thread(s) with 1.536 CPU-seconds total
            POV-Ray finished
            """));
    }

    @Test
    void aPovRayThatFailedHasNoTime() {
        assertEquals(OptionalDouble.empty(), PovRay.traceMilliseconds("Parse Error: no such thing\nRender failed\n"));
    }

    @Test
    void picturesOfSixteenBitsAreReadAsTheyAre(@TempDir Path folder) throws Exception {
        ComponentColorModel model = new ComponentColorModel(ColorSpace.getInstance(ColorSpace.CS_sRGB), false, false,
            Transparency.OPAQUE, DataBuffer.TYPE_USHORT);
        WritableRaster raster = model.createCompatibleWritableRaster(2, 1);
        raster.setPixel(1, 0, new int[] {65535, 257, 1});
        Path picture = folder.resolve("deep.png");
        ImageIO.write(new BufferedImage(model, raster, false, null), "png", picture.toFile());
        Film film = PovRay.film(picture);
        assertEquals(0, film.get(0, 0).red());
        assertEquals(1, film.get(1, 0).red());
        assertEquals(1 / 255.0, film.get(1, 0).green(), 1e-15);
        assertEquals(1 / 65535.0, film.get(1, 0).blue(), 1e-15);
    }

    @Test
    void aShrunkPictureHasTheMeansOfWhatIsShown() {
        Film film = new Film(4, 2);
        film.set(0, 0, 4, 1, 0);
        film.set(1, 1, 0.5, 0, 0);
        film.set(3, 1, 0, 0, 1);
        Film shrunk = Films.shrunk(film, 2);
        assertEquals(2, shrunk.width());
        assertEquals(1, shrunk.height());
        assertEquals(1.5 / 4, shrunk.get(0, 0).red());
        assertEquals(0.25, shrunk.get(0, 0).green());
        assertEquals(0.25, shrunk.get(1, 0).blue());
    }

    @Test
    void atEqualErrorEachProgramsBestMethodCounts() {
        List<List<String>> rows = study().equalError().rows();
        assertEquals(List.of("4", "≤ 1.00 ms", "fast", "≤ 1.00 ms", "best", "1"), rows.get(0));
        assertEquals(List.of("2", "4.00 ms", "fast", "2.00 ms", "best", "2"), rows.get(1));
        assertEquals(List.of("1", "16.0 ms", "fast", "4.00 ms", "best", "4"), rows.get(2));
    }

    @Test
    void farBelowWhatWasMeasuredNothingIsGuessed() {
        Curve curve = halving("ours: best", 1, 2);
        assertEquals(EqualError.Origin.EXTRAPOLATED, curve.at(0.13 / 255).orElseThrow().origin());
        assertTrue(curve.at(0.12 / 255).isEmpty());
    }

    @Test
    void aSentenceSaysWhoNeedsHowMuch() {
        assertEquals("Soft shadows, one ray a pixel: for an error of 0.5 steps POV-Ray needs 8 times the processor time of "
            + "ours.",
            study().sentence());
    }

    @Test
    void allSettingsOfBothAreInTheTableAndOnThePlot() throws Exception {
        assertEquals(15, study().settings().rows().size());
        assertTrue(study().plot().onWhite().startsWith("<svg "));
    }
}
