package raytracing.preview;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;

/** Sentences over the picture: as high as they need, up to the height of the picture. A click hides them. */
final class MessagePanel extends JScrollPane {
    private static final long serialVersionUID = 1;
    private static final Color PAPER = new Color(0x2b2320);
    private static final Color INK = new Color(0xf2ebe4);
    private static final Color EDGE = new Color(0xd9822b);
    private static final int EDGE_WIDTH = 4;
    private static final int MARGIN = 7;
    private static final float FONT_SIZE = 13;

    private final transient JTextArea text = wrapped(PAPER, INK);

    MessagePanel() {
        super(VERTICAL_SCROLLBAR_AS_NEEDED, HORIZONTAL_SCROLLBAR_NEVER);
        setBorder(BorderFactory.createMatteBorder(0, EDGE_WIDTH, 0, 0, EDGE));
        text.setBorder(BorderFactory.createEmptyBorder(MARGIN, MARGIN, MARGIN, MARGIN));
        text.setFont(text.getFont().deriveFont(FONT_SIZE));
        text.setToolTipText("a click hides this");
        text.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent event) {
                setVisible(false);
            }
        });
        setViewportView(text);
        setVisible(false);
    }

    /** An empty text whose lines are broken between words. */
    static JTextArea wrapped(Color paper, Color ink) {
        JTextArea text = new JTextArea();
        text.setBackground(paper);
        text.setForeground(ink);
        text.setLineWrap(true);
        text.setWrapStyleWord(true);
        text.setEditable(false);
        text.setFocusable(false);                // so that the picture gets the keys
        return text;
    }

    /** Shows sentences, each on a line of its own, in place of earlier ones; hides the panel if there are none. */
    void show(List<String> sentences) {
        text.setText(String.join("\n", sentences));
        text.setCaretPosition(0);
        setVisible(!sentences.isEmpty());
        getParent().revalidate();                // since a scroll pane does not request a new layout by itself
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(0, Math.min(getParent().getHeight(), heightIn(getWidth() - EDGE_WIDTH, text)));
    }

    /** The height of a text whose lines are broken at a width; leaves the text unchanged. */
    static int heightIn(int width, JTextArea text) {
        Dimension size = text.getSize();
        text.setSize(Math.max(1, width), Short.MAX_VALUE);
        int height = text.getPreferredSize().height;
        text.setSize(size);
        return height;
    }
}
