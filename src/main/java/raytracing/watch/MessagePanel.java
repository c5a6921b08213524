package raytracing.watch;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;

/** Sentences over the picture: as high as they need, up to the height of the picture. A click takes them away. */
final class MessagePanel extends JScrollPane {
    private static final long serialVersionUID = 1;
    private static final Color PAPER = new Color(0x2b2320);
    private static final Color INK = new Color(0xf2ebe4);
    private static final Color EDGE = new Color(0xd9822b);
    private static final int EDGE_WIDTH = 4;
    private static final int MARGIN = 7;
    private static final float FONT_SIZE = 13;

    private final transient JTextArea text = new JTextArea();

    MessagePanel() {
        super(VERTICAL_SCROLLBAR_AS_NEEDED, HORIZONTAL_SCROLLBAR_NEVER);
        setBorder(BorderFactory.createMatteBorder(0, EDGE_WIDTH, 0, 0, EDGE));
        text.setBackground(PAPER);
        text.setForeground(INK);
        text.setBorder(BorderFactory.createEmptyBorder(MARGIN, MARGIN, MARGIN, MARGIN));
        text.setFont(text.getFont().deriveFont(FONT_SIZE));
        text.setLineWrap(true);
        text.setWrapStyleWord(true);
        text.setEditable(false);
        text.setFocusable(false);                // keys go on to the picture
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

    /** Shows sentences, each on a line of its own, instead of those before; nothing if there are none. */
    void say(List<String> sentences) {
        text.setText(String.join("\n", sentences));
        text.setCaretPosition(0);
        setVisible(!sentences.isEmpty());
        getParent().revalidate();                // for a scroll pane itself does not ask for another place
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(0, Math.min(getParent().getHeight(), heightIn(getWidth() - EDGE_WIDTH, text)));
    }

    /** How high a text is whose lines are broken at a width; the text itself stays as it is. */
    static int heightIn(int width, JTextArea text) {
        Dimension size = text.getSize();
        text.setSize(Math.max(1, width), Short.MAX_VALUE);
        int height = text.getPreferredSize().height;
        text.setSize(size);
        return height;
    }
}
