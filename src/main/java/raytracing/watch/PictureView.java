package raytracing.watch;

import java.awt.Color;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import java.util.function.UnaryOperator;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;
import raytracing.render.Region;

/**
 * Shows a picture through a {@link Viewport} that the mouse moves. Counts in pixels of the screen, of which Swing's own
 * units may have several, so that one to one is one to one on fine screens too.
 */
final class PictureView extends JComponent {
    private static final long serialVersionUID = 1;
    static final Color SURROUNDINGS = new Color(0x242628);

    private transient ShownPicture picture;
    private final transient Runnable lookedElsewhere;
    private transient Viewport viewport;
    private transient Optional<Point> pointer = Optional.empty();

    /**
     * Shows a picture.
     *
     * @param picture to be shown
     * @param lookedElsewhere is run when the viewport or the pointer moved
     */
    PictureView(ShownPicture picture, Runnable lookedElsewhere) {
        this.picture = picture;
        this.lookedElsewhere = lookedElsewhere;
        viewport = Viewport.fit(pictureSize(), new Viewport.Size(0, 0));
        setOpaque(true);
        Hand hand = new Hand();
        addMouseListener(hand);
        addMouseMotionListener(hand);
        addMouseWheelListener(hand);
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                followSize();
                lookedElsewhere.run();
            }
        });
    }

    /** Shows another picture of the same size in its place. */
    void show(ShownPicture other) {
        picture = other;
        repaint();
    }

    Viewport.Size pictureSize() {
        return new Viewport.Size(picture.region().width(), picture.region().height());
    }

    /** Pixels of the screen in one of Swing's units, in a row. */
    double density() {
        return getGraphicsConfiguration() == null ? 1 : getGraphicsConfiguration().getDefaultTransform().getScaleX();
    }

    double scale() {
        return viewport.scale();
    }

    /** The pixel of the picture under the pointer, if there is one. */
    Optional<Point> pixelUnderPointer() {
        Viewport shown = viewport;
        return pointer.filter(at -> shown.showsPictureAt(at.x, at.y)).map(at -> new Point(shown.column(at.x), shown.row(at.y)));
    }

    /** Looks at the picture in another way, which may depend on a place: the pointer's, or else the middle. */
    void look(UnaryOperator<Viewport> change) {
        Viewport before = viewport;
        viewport = change.apply(viewport);
        if (!before.equals(viewport)) {
            repaint();
            lookedElsewhere.run();
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

    private Point place() {
        return pointer.orElseGet(() -> new Point(viewport.view().width() / 2, viewport.view().height() / 2));
    }

    /** Some pixels of the picture changed. */
    void repaint(Region changed) {
        Rectangle places = viewport.onView(changed);
        if (!places.isEmpty()) {
            double density = density();
            int x = (int) Math.floor(places.x / density);
            int y = (int) Math.floor(places.y / density);
            repaint(x, y, (int) Math.ceil((places.x + places.width) / density) - x,
                (int) Math.ceil((places.y + places.height) / density) - y);
        }
    }

    private void followSize() {
        Viewport.Size size = new Viewport.Size((int) (getWidth() * density()), (int) (getHeight() * density()));
        if (!size.equals(viewport.view())) {
            viewport = viewport.resized(size);
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
            Region part = viewport.visible();
            picture.image().ifPresent(image -> draw(image, part, viewport.placeOf(part), brush));
        } finally {
            brush.dispose();
        }
    }

    /** Nothing but what is in view: places and sizes above 65,535 are too large for Java's own drawing. */
    private static void draw(Image image, Region part, Rectangle place, Graphics2D brush) {
        brush.drawImage(image, place.x, place.y, place.x + place.width, place.y + place.height,
            part.left(), part.top(), part.right(), part.bottom(), null);
    }

    /** What the mouse does. */
    private final class Hand extends MouseAdapter {
        private Point grip = new Point();

        private Point at(MouseEvent event) {
            return new Point((int) (event.getX() * density()), (int) (event.getY() * density()));
        }

        private void point(Optional<Point> place) {
            pointer = place;
            lookedElsewhere.run();
        }

        @Override
        public void mouseEntered(MouseEvent event) {
            point(Optional.of(at(event)));
        }

        @Override
        public void mouseMoved(MouseEvent event) {
            point(Optional.of(at(event)));
        }

        @Override
        public void mouseExited(MouseEvent event) {
            point(Optional.empty());
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
            point(Optional.of(now));
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
