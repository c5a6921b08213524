package raytracing.preview;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
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

/** The window of a preview: the picture with messages over it and a status line below. Used by Swing's thread alone. */
final class PreviewWindow {
    /** Changes are shown 16 times a second. */
    private static final int REFRESH_MILLISECONDS = 60;

    private static final String KEYS =
        ", wheel or + - zooms, dragging moves, 0 or a double click shows all, 1 is one to one";

    /** A picture that replaces another one is shown only after this time, when most are finished. */
    private static final long UNSEEN_NANOSECONDS = 250_000_000;

    private final String name;
    private final String idle;
    private final Runnable stop;
    private final JFrame frame;
    private final PictureView view;
    private final MessagePanel messages = new MessagePanel();
    private final StatusLine status = new StatusLine();
    private final Timer timer = new Timer(REFRESH_MILLISECONDS, event -> refresh());
    private Supplier<String> title;
    private Escape escape;

    /** The picture that is drawn now and shown soon, and since when. */
    private Optional<ShownPicture> next = Optional.empty();
    private long nextSince;

    /** What the Escape key does: stops the drawing, nothing while that takes, or closes the window. */
    enum Escape { STOPS, WAITS, CLOSES }

    /**
     * Opens a window.
     *
     * @param name of the picture, the first title
     * @param escape what the key does until the picture is finished
     * @param idle status while the pointer is not over the picture
     * @param stop runs if Escape stops the drawing
     * @param close runs when the window is closed
     */
    PreviewWindow(String name, ShownPicture picture, Escape escape, String idle, Runnable stop, Runnable close) {
        this.name = name;
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
        bind("ESCAPE", this::escape);
        bind("typed 0", view::fit);
        bind("typed 1", view::oneToOne);
        bind("typed +", view::closer);
        bind("typed -", view::farther);
        describe();
        setSize();
        frame.setLocationRelativeTo(null);
        frame.setVisible(true);
        timer.start();
    }

    /**
     * As large as the picture, if the screen allows. The first size is right in most cases and need not change: without a
     * window manager, X may report an earlier size so late that Java takes it for the last one.
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
        Viewport.Size room = new Viewport.Size((int) (density * (screen.width - borders.left - borders.right)),
            (int) (density * (screen.height - borders.top - borders.bottom - status.getPreferredSize().height)));
        Viewport.Size size = view.pictureSize().within(room);
        int width = Math.max(PictureView.LEAST_SIZE.width, (int) Math.ceil(size.width() / density));
        int height = Math.max(PictureView.LEAST_SIZE.height, (int) Math.ceil(size.height() / density));
        view.setPreferredSize(new Dimension(width, height));
        status.setSize(width, status.getHeight());      // which decides how many lines the keys take
    }

    private void bind(String key, Runnable action) {
        view.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke(key), key);
        view.getActionMap().put(key, new AbstractAction() {
            private static final long serialVersionUID = 1;

            @Override
            public void actionPerformed(ActionEvent event) {
                action.run();
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

    /** From now on, the title has these words, which are queried at every refresh. */
    void follow(Supplier<String> words) {
        if (escape != Escape.WAITS) {
            title = words;
        }
    }

    /** Shows sentences over the picture, in place of earlier ones. */
    void showMessages(List<String> sentences) {
        messages.show(sentences);
    }

    /** Another picture replaces this one shortly, when there is something new to see of it. */
    void showSoon(ShownPicture other) {
        next = Optional.of(other);
        nextSince = System.nanoTime();
    }

    /** Shows a finished picture. */
    void end(ShownPicture ended, String summary) {
        show(ended);
        escape = Escape.CLOSES;
        title = () -> summary;
        refresh();
        describe();
    }

    private void show(ShownPicture picture) {
        next = Optional.empty();
        view.show(picture);
    }

    /** Shows what is new. */
    private void refresh() {
        if (System.nanoTime() - nextSince > UNSEEN_NANOSECONDS) {
            next.ifPresent(this::show);
        }
        view.repaintChanges();
        String words = title.get();
        if (!words.equals(frame.getTitle())) {
            frame.setTitle(words);
        }
    }

    /** Updates the status line. */
    private void describe() {
        status.show(view.pixelUnderPointer().orElse(idle), view.scale(),
            "Esc " + (escape == Escape.CLOSES ? "closes" : "stops") + KEYS);
    }
}
