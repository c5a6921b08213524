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
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.KeyStroke;
import javax.swing.Timer;
import javax.swing.WindowConstants;

/** The window of a preview: a view of the picture, a line under it, the title above. All is called in Swing's thread. */
final class PreviewWindow {
    /** How often it is asked what changed: 16 times a second. */
    private static final int REFRESH_MILLISECONDS = 60;

    /** Room for a title that can be read; the least size of a view, in Swing's units. */
    private static final Dimension LEAST_VIEW = new Dimension(320, 200);

    private final String name;
    private final ShownPicture picture;
    private final Wishes wishes;
    private final JFrame frame;
    private final PictureView view;
    private final StatusLine status = new StatusLine();
    private final Timer timer = new Timer(REFRESH_MILLISECONDS, event -> refresh());
    private Supplier<String> title;
    private State state = State.DRAWING;

    /** What Esc would do. */
    private enum State {
        /** Stops the drawing. */
        DRAWING,

        /** Nothing more. */
        STOPPING,

        /** Closes the window. */
        OVER
    }

    /** What the user wishes while the picture is drawn. */
    interface Wishes {
        /** That it be drawn no further. */
        void stop();

        /** That it be shown no further. */
        void close();
    }

    /**
     * Opens a window.
     *
     * @param name of the picture, its title for now
     * @param picture to be shown
     * @param wishes is told the user's
     */
    PreviewWindow(String name, ShownPicture picture, Wishes wishes) {
        this.name = name;
        this.picture = picture;
        this.wishes = wishes;
        title = () -> name;
        view = new PictureView(picture, this::describe);
        frame = new JFrame(name);
        frame.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                timer.stop();
                wishes.close();
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

    /** As large as the picture, if the screen is. */
    private void setSize() {
        frame.pack();                       // now it has the borders that the system gives it
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        Insets borders = frame.getInsets();
        double density = view.density();
        Viewport.Size room = new Viewport.Size(
            (int) (density * (screen.width - borders.left - borders.right)),
            (int) (density * (screen.height - borders.top - borders.bottom - status.getPreferredSize().height)));
        Viewport.Size size = view.pictureSize().within(room);
        view.setPreferredSize(new Dimension(Math.max(LEAST_VIEW.width, (int) Math.ceil(size.width() / density)),
            Math.max(LEAST_VIEW.height, (int) Math.ceil(size.height() / density))));
        frame.pack();
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
        if (state == State.OVER) {
            frame.dispose();
        } else if (state == State.DRAWING) {
            state = State.STOPPING;
            title = () -> name + " - stopping";
            wishes.stop();
        }
    }

    /** From now on, the title says what it is told, whenever it is asked. */
    void follow(Supplier<String> words) {
        if (state == State.DRAWING) {
            title = words;
        }
    }

    /** The picture is what it will be. */
    void end(String summary) {
        state = State.OVER;
        title = () -> summary;
        refresh();
        describe();
    }

    /** Shows what is new. */
    private void refresh() {
        picture.takeChanges().ifPresent(changed -> {
            view.repaint(changed);
            describe();
        });
        String words = title.get();
        if (!words.equals(frame.getTitle())) {
            frame.setTitle(words);
        }
    }

    /** What the line under the picture says. */
    private void describe() {
        Optional<Point> pixel = view.pixelUnderPointer();
        status.say(pixel.isPresent() ? picture.describe(pixel.get().x, pixel.get().y)
            : "Esc " + (state == State.OVER ? "closes" : "stops") + ", wheel zooms, dragging moves, 0 fits, 1 is one to one");
        status.say(view.scale());
    }
}
