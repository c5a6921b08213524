package raytracing.preview;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Rectangle;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import raytracing.render.Region;

class ViewportTest {
    private static final Viewport.Size PICTURE = new Viewport.Size(300, 200);
    private static final int TIMES = 2000;

    private final Random random = new Random(1);

    private Viewport randomViewport() {
        Viewport viewport = Viewport.fit(new Viewport.Size(1 + random.nextInt(3000), 1 + random.nextInt(3000)),
            new Viewport.Size(1 + random.nextInt(1500), 1 + random.nextInt(1500)));
        for (int i = random.nextInt(8); i > 0; i--) {
            viewport = viewport.closer(placeX(viewport), placeY(viewport))
                .moved(random.nextInt(400) - 200, random.nextInt(400) - 200);
        }
        return viewport;
    }

    /** Somewhere in the view, on the picture. */
    private int placeX(Viewport shown) {
        int first = (int) Math.max(0, shown.left());
        int last = (int) Math.min(shown.view().width() - 1L,
            Math.floor(shown.left() + shown.picture().width() * shown.scale()) - 1);
        return first + random.nextInt(Math.max(1, last - first + 1));
    }

    private int placeY(Viewport shown) {
        int first = (int) Math.max(0, shown.top());
        int last = (int) Math.min(shown.view().height() - 1L,
            Math.floor(shown.top() + shown.picture().height() * shown.scale()) - 1);
        return first + random.nextInt(Math.max(1, last - first + 1));
    }

    @ParameterizedTest(name = "{0} x {1} in {2} x {3}: {4}")
    @CsvSource({
        "300, 200, 300, 200, 1, 0, 0",          // the same
        "300, 200, 599, 500, 1, 149, 150",      // not yet twice as large
        "300, 200, 600, 500, 2, 0, 50",
        "300, 200, 2400, 1600, 8, 0, 0",
        "300, 200, 150, 200, 0.5, 0, 50",
        "400, 200, 300, 300, 0.75, 0, 75",      // any scale below 1
        "1, 1, 1000, 900, 64, 468, 418",        // no larger than that
    })
    void allOfThePictureIsInTheMiddle(int width, int height, int viewWidth, int viewHeight, double scale, int left, int top) {
        Viewport.Size picture = new Viewport.Size(width, height);
        Viewport.Size view = new Viewport.Size(viewWidth, viewHeight);
        assertEquals(new Viewport(picture, view, scale, left, top), Viewport.fit(picture, view));
    }

    @Test
    void thePixelUnderThePointerStaysThereOnTheWayIn() {
        for (int i = 0; i < TIMES; i++) {
            Viewport shown = randomViewport();
            int x = placeX(shown);
            int y = placeY(shown);
            Viewport closer = shown.closer(x, y);
            if (closer.isFit()) {
                continue;                        // then it is in the middle
            }
            assertTrue(Math.abs(closer.column(x) - (x - shown.left()) / shown.scale()) < 1 / Math.min(1, closer.scale()),
                shown::toString);
            assertTrue(Math.abs(closer.row(y) - (y - shown.top()) / shown.scale()) < 1 / Math.min(1, closer.scale()),
                shown::toString);
            if (shown.scale() >= 1) {
                assertEquals(shown.column(x), closer.column(x), shown::toString);
                assertEquals(shown.row(y), closer.row(y), shown::toString);
            }
        }
    }

    @Test
    void theWayInAndOutLeadsBack() {
        for (int i = 0; i < TIMES; i++) {
            Viewport shown = randomViewport();
            int x = placeX(shown);
            int y = placeY(shown);
            if (shown.scale() >= 1 && shown.scale() < 64) {
                assertEquals(shown, shown.closer(x, y).farther(x, y));
            }
        }
    }

    @Test
    void theWheelGoesThroughPowersOfTwoUpTo64() {
        Viewport shown = Viewport.fit(PICTURE, new Viewport.Size(100, 100));
        double[] scales = {1 / 3.0, 0.5, 1, 2, 4, 8, 16, 32, 64, 64};
        for (double scale : scales) {
            assertEquals(scale, shown.scale());
            shown = shown.closer(50, 50);
        }
        for (int i = scales.length - 2; i >= 0; i--) {
            assertEquals(scales[i], shown.scale());
            shown = shown.farther(50, 50);
        }
        assertEquals(Viewport.fit(PICTURE, new Viewport.Size(100, 100)), shown);
    }

    @Test
    void oneToOneIsSoAlsoWhereTheWindowHasRoomForMore() {
        Viewport shown = Viewport.fit(PICTURE, new Viewport.Size(700, 500));
        assertEquals(2, shown.scale());
        Viewport oneToOne = shown.oneToOne(350, 250);
        assertEquals(1, oneToOne.scale());
        assertEquals(oneToOne, oneToOne.farther(350, 250));
        assertEquals(shown, oneToOne.fit());
    }

    @Test
    void thePictureCannotBeLost() {
        for (int i = 0; i < TIMES; i++) {
            Viewport shown = randomViewport().moved(random.nextInt(), random.nextInt())
                .resized(new Viewport.Size(1 + random.nextInt(1500), 1 + random.nextInt(1500)));
            Viewport checked = shown;
            assertTrue(shown.showsPictureAt(shown.view().width() / 2, shown.view().height() / 2), checked::toString);
        }
    }

    @Test
    void aLargerWindowStillShowsAllOrWhatWasInTheMiddle() {
        Viewport all = Viewport.fit(PICTURE, PICTURE);
        assertTrue(all.resized(new Viewport.Size(600, 400)).isFit());
        Viewport part = all.closer(100, 100).closer(100, 100);
        Viewport larger = part.resized(new Viewport.Size(500, 360));
        assertEquals(part.column(150), larger.column(250));
        assertEquals(part.row(100), larger.row(180));
        assertEquals(part.scale(), larger.scale());
    }

    @Test
    void aViewWithoutRoomShowsNothingAndDoesNotFail() {
        Viewport shown = Viewport.fit(PICTURE, new Viewport.Size(0, 0));
        assertTrue(shown.onView(new Region(0, 0, 300, 200)).isEmpty());
        assertTrue(shown.resized(PICTURE).isFit());
    }

    @Test
    void onThePictureIsWhereItsFirstAndLastPixelAre() {
        Viewport shown = Viewport.fit(PICTURE, new Viewport.Size(640, 480));
        assertEquals(20, shown.left());
        assertTrue(shown.showsPictureAt(20, 40));
        assertFalse(shown.showsPictureAt(19, 40));
        assertTrue(shown.showsPictureAt(619, 439));
        assertFalse(shown.showsPictureAt(620, 439));
    }

    /** Exactly there at scales from 1 on; below, each is blurred with its neighbours. */
    @Test
    void aChangedRectangleIsWhereItsPixelsAreSeen() {
        for (int i = 0; i < TIMES / 10; i++) {
            Viewport shown = randomViewport();
            int left = random.nextInt(shown.picture().width());
            int top = random.nextInt(shown.picture().height());
            Region part = new Region(left, top, left + 1 + random.nextInt(shown.picture().width() - left),
                top + 1 + random.nextInt(shown.picture().height() - top));
            Rectangle seen = new Rectangle(0, 0, -1, -1);
            for (int y = 0; y < shown.view().height(); y++) {
                if (shown.row(y) >= part.top() && shown.row(y) < part.bottom()) {
                    for (int x = 0; x < shown.view().width(); x++) {
                        if (shown.column(x) >= part.left() && shown.column(x) < part.right()) {
                            seen.add(new Rectangle(x, y, 1, 1));
                        }
                    }
                }
            }
            Rectangle places = shown.onView(part);
            assertTrue(seen.isEmpty() || places.contains(seen), shown::toString);
            if (shown.scale() >= 1) {
                assertTrue(seen.isEmpty() ? places.isEmpty() : places.equals(seen), shown::toString);
            }
        }
    }

    @ParameterizedTest(name = "{0} x {1}")
    @CsvSource({"300, 200, 300, 200", "1300, 200, 1000, 154", "300, 1600, 150, 800", "4000, 1, 1000, 1"})
    void aWindowIsAsLargeAsThePictureOrOfItsShape(int width, int height, int expectedWidth, int expectedHeight) {
        assertEquals(new Viewport.Size(expectedWidth, expectedHeight),
            new Viewport.Size(width, height).within(new Viewport.Size(1000, 800)));
    }
}
