package raytracing.watch;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Insets;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.KeyStroke;
import javax.swing.Timer;
import javax.swing.WindowConstants;

/**
 * The window of a preview: a view of the picture, with sentences over it if there are some, two lines under it, the title above.
 * All is called in Swing's thread.
 */
final class PreviewWindow {
    /** How often it is asked what changed: 16 times a second. */
    private static final int REFRESH_MILLISECONDS = 60;

    /** Room for a title that can be read; the least size of a view, in Swing's units. */
    static final Dimension LEAST_VIEW = new Dimension(320, 200);

    private static final String KEYS =
        ", wheel or + - zooms, dragging moves, 0 or a double click shows all, 1 is one to one";

    /** For so long a picture that takes the place of another one is drawn unseen: most are finished by then. */
    private static final long UNSEEN_NANOSECONDS = 250_000_000;

    private final String name;
    private final String idle;
    private final Runnable stop;
    private final JFrame frame;
    private final PictureView view;
    private final MessagePanel messages = new MessagePanel();
    private final StatusLine status = new StatusLine();
    private final Timer timer = new Timer(REFRESH_MILLISECONDS, event -> refresh());
    private ShownPicture picture;
    private Supplier<String> title;
    private Escape escape;

    /** A picture that will be shown instead, and since when it is drawn. */
    private Optional<ShownPicture> next = Optional.empty();
    private long nextSince;

    /** What the key does. */
    enum Escape {
        /** Stops the drawing. */
        STOPS,

        /** Nothing: the drawing is being stopped. */
        WAITS,

        /** Closes the window. */
        CLOSES
    }

    /**
     * Opens a window.
     *
     * @param name of the picture, its title for now
     * @param picture to be shown
     * @param escape what the key does until the picture is finished
     * @param idle what the line under the picture says if the pointer is elsewhere
     * @param stop is run if Esc stops the drawing
     * @param close is run when the window is closed
     */
    PreviewWindow(String name, ShownPicture picture, Escape escape, String idle, Runnable stop, Runnable close) {
        this.name = name;
        this.picture = picture;
        this.escape = escape;
        this.idle = idle;
        this.stop = stop;
        title = () -> name;
        view = new PictureView(picture, this::describe);
        view.setLayout(new BorderLayout());
        view.add(messages, BorderLayout.NORTH);
        frame = new JFrame(name);
        frame.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                timer.stop();
                close.run();
            }
        });
        frame.add(view, BorderLayout.CENTER);
        frame.add(status, BorderLayout.SOUTH);
        bindKeys();
        describe();
        setSize();
        frame.setLocationRelativeTo(null);
        frame.setVisible(true);
        timer.start();
    }

    /**
     * As large as the picture, if the screen is. The size is right already when the window is made, and mostly stays: where no
     * window manager runs, X may tell of an earlier size so late that Java takes it for the last one.
     */
    private void setSize() {
        fitInto(new Insets(0, 0, 0, 0));
        frame.pack();                       // now it has the borders that the system gives it
        fitInto(frame.getInsets());
        frame.pack();
    }

    private void fitInto(Insets borders) {
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        double density = view.density();
        Viewport.Size room = new Viewport.Size(
            (int) (density * (screen.width - borders.left - borders.right)),
            (int) (density * (screen.height - borders.top - borders.bottom - status.getPreferredSize().height)));
        Viewport.Size size = view.pictureSize().within(room);
        int width = Math.max(LEAST_VIEW.width, (int) Math.ceil(size.width() / density));
        view.setPreferredSize(new Dimension(width, Math.max(LEAST_VIEW.height, (int) Math.ceil(size.height() / density))));
        status.setSize(width, status.getHeight());      // which decides how many lines the keys take
    }

    private void bindKeys() {
        bind(KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0), this::escape);
        bind(KeyStroke.getKeyStroke('0'), view::fit);
        bind(KeyStroke.getKeyStroke('1'), view::oneToOne);
        bind(KeyStroke.getKeyStroke('+'), view::closer);
        bind(KeyStroke.getKeyStroke('-'), view::farther);
    }

    private void bind(KeyStroke key, Runnable deed) {
        view.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(key, key);
        view.getActionMap().put(key, new AbstractAction() {
            private static final long serialVersionUID = 1;

            @Override
            public void actionPerformed(ActionEvent event) {
                deed.run();
            }
        });
    }

    private void escape() {
        if (escape == Escape.CLOSES) {
            frame.dispose();
        } else if (escape == Escape.STOPS) {
            escape = Escape.WAITS;
            title = () -> name + " - stopping";
            stop.run();
        }
    }

    /** From now on, the title says what it is told, whenever it is asked. */
    void follow(Supplier<String> words) {
        if (escape != Escape.WAITS) {
            title = words;
        }
    }

    /** What is over the picture from now on, if anything. */
    void say(List<String> sentences) {
        messages.say(sentences);
    }

    /** Another picture takes this one's place, as soon as there is something new to see of it. */
    void showSoon(ShownPicture other) {
        next = Optional.of(other);
        nextSince = System.nanoTime();
    }

    private void show(ShownPicture other) {
        next = Optional.empty();
        if (other != picture) {
            picture = other;
            view.show(other);
        }
    }

    /** This picture is what it will be. */
    void end(ShownPicture ended, String summary) {
        show(ended);
        escape = Escape.CLOSES;
        title = () -> summary;
        refresh();
        describe();
    }

    /** Shows what is new. */
    private void refresh() {
        if (System.nanoTime() - nextSince > UNSEEN_NANOSECONDS) {
            next.ifPresent(this::show);
        }
        picture.takeChanges().ifPresent(changed -> {
            view.repaint(changed);
            describe();
        });
        String words = title.get();
        if (!words.equals(frame.getTitle())) {
            frame.setTitle(words);
        }
    }

    /** What the lines under the picture say. */
    private void describe() {
        Optional<Point> pixel = view.pixelUnderPointer();
        status.say(pixel.isPresent() ? picture.describe(pixel.get().x, pixel.get().y) : idle, view.scale(),
            "Esc " + (escape == Escape.CLOSES ? "closes" : "stops") + KEYS);
    }
}
