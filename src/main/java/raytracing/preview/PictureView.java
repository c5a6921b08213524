package raytracing.preview;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Graphics;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import java.util.function.UnaryOperator;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;
import raytracing.render.Region;

/**
 * Shows a picture through a {@link Viewport} that the mouse moves. Coordinates are pixels of the screen, of which one of
 * Swing's units may have several, so that one to one is exact on fine screens too.
 */
final class PictureView extends JComponent {
    private static final long serialVersionUID = 1;
    static final Color SURROUNDINGS = new Color(0x242628);

    /** Room for a title that can be read; in Swing's units. */
    static final Dimension LEAST_SIZE = new Dimension(320, 200);

    private transient ShownPicture picture;
    private final transient Runnable viewChanged;
    private transient Viewport viewport;
    private transient Optional<Point> pointer = Optional.empty();

    /** Shows a picture; the action runs when the viewport, the pointer or the pixels have changed. */
    PictureView(ShownPicture picture, Runnable viewChanged) {
        this.picture = picture;
        this.viewChanged = viewChanged;
        viewport = Viewport.fit(pictureSize(), new Viewport.Size(0, 0));
        setOpaque(true);
        MouseAdapter mouse = new Mouse();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
    }

    /** Shows another picture of the same size. */
    void show(ShownPicture other) {
        picture = other;
        repaint();
    }

    Viewport.Size pictureSize() {
        return new Viewport.Size(picture.region().width(), picture.region().height());
    }

    /** How many pixels of the screen one of Swing's units is wide. */
    double density() {
        return getGraphicsConfiguration() == null ? 1 : getGraphicsConfiguration().getDefaultTransform().getScaleX();
    }

    double scale() {
        return viewport.scale();
    }

    /** Describes the pixel of the picture under the pointer, if there is one. */
    Optional<String> pixelUnderPointer() {
        return pointer.filter(at -> viewport.showsPictureAt(at.x, at.y))
            .map(at -> picture.describe(viewport.column(at.x), viewport.row(at.y)));
    }

    /** Changes the viewport. */
    void look(UnaryOperator<Viewport> change) {
        Viewport before = viewport;
        viewport = change.apply(viewport);
        if (!before.equals(viewport)) {
            repaint();
            viewChanged.run();
        }
    }

    void fit() {
        look(Viewport::fit);
    }

    void oneToOne() {
        look(shown -> shown.oneToOne(place().x, place().y));
    }

    void closer() {
        look(shown -> shown.closer(place().x, place().y));
    }

    void farther() {
        look(shown -> shown.farther(place().x, place().y));
    }

    /** The place that keeps still when the scale changes: the pointer's, or else the middle. */
    private Point place() {
        return pointer.orElseGet(() -> new Point(viewport.view().width() / 2, viewport.view().height() / 2));
    }

    /** Repaints the pixels of the picture that have changed. */
    void repaintChanges() {
        Optional<Region> changes = picture.takeChanges();
        if (changes.isPresent()) {
            Rectangle places = viewport.onView(changes.get());
            double density = density();
            int x = (int) Math.floor(places.x / density);
            int y = (int) Math.floor(places.y / density);
            repaint(x, y, (int) Math.ceil((places.x + places.width) / density) - x,
                (int) Math.ceil((places.y + places.height) / density) - y);
            viewChanged.run();
        }
    }

    private void followSize() {
        Viewport.Size size = new Viewport.Size((int) (getWidth() * density()), (int) (getHeight() * density()));
        if (!size.equals(viewport.view())) {
            viewport = viewport.resized(size);
            viewChanged.run();
        }
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        followSize();
        Graphics2D brush = (Graphics2D) graphics.create();
        try {
            brush.setColor(SURROUNDINGS);
            brush.fillRect(0, 0, getWidth(), getHeight());
            brush.scale(1 / density(), 1 / density());
            brush.setRenderingHint(RenderingHints.KEY_INTERPOLATION, viewport.scale() < 1
                ? RenderingHints.VALUE_INTERPOLATION_BILINEAR : RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
            // Only the part in view, since coordinates and sizes above 65,535 are too large for Java's own drawing.
            Region part = viewport.visible();
            Rectangle place = viewport.placeOf(part);
            picture.image().ifPresent(image -> brush.drawImage(image, place.x, place.y, place.x + place.width,
                place.y + place.height, part.left(), part.top(), part.right(), part.bottom(), null));
        } finally {
            brush.dispose();
        }
    }

    /** Follows the mouse. */
    private final class Mouse extends MouseAdapter {
        private Point grip = new Point();

        private Point at(MouseEvent event) {
            return new Point((int) (event.getX() * density()), (int) (event.getY() * density()));
        }

        @Override
        public void mouseEntered(MouseEvent event) {
            pointer = Optional.of(at(event));
            viewChanged.run();
        }

        @Override
        public void mouseMoved(MouseEvent event) {
            mouseEntered(event);
        }

        @Override
        public void mouseExited(MouseEvent event) {
            pointer = Optional.empty();
            viewChanged.run();
        }

        @Override
        public void mousePressed(MouseEvent event) {
            grip = at(event);
        }

        @Override
        public void mouseDragged(MouseEvent event) {
            Point now = at(event);
            look(shown -> shown.moved(now.x - grip.x, now.y - grip.y));
            grip = now;
            mouseEntered(event);
        }

        @Override
        public void mouseClicked(MouseEvent event) {
            if (SwingUtilities.isLeftMouseButton(event) && event.getClickCount() == 2) {
                fit();
            }
        }

        @Override
        public void mouseWheelMoved(MouseWheelEvent event) {
            pointer = Optional.of(at(event));
            if (event.getWheelRotation() < 0) {
                closer();
            } else if (event.getWheelRotation() > 0) {
                farther();
            }
        }
    }
}
