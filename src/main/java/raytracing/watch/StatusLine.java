package raytracing.watch;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.util.Locale;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;

/** Under the picture: the pixel under the pointer and the scale in one line, and what the keys do in as many as that takes. */
final class StatusLine extends JPanel {
    private static final long serialVersionUID = 1;
    private static final Color PAPER = new Color(0x1c1d1f);
    private static final Color INK = new Color(0xb8bbc0);
    private static final int MARGIN = 6;

    private final transient JLabel words = label();
    private final transient JLabel scale = label();
    private final transient JTextArea keys = new JTextArea();

    StatusLine() {
        super(new BorderLayout(MARGIN, 0));
        setBackground(PAPER);
        setBorder(BorderFactory.createEmptyBorder(2, MARGIN, 2, MARGIN));
        keys.setOpaque(false);
        keys.setForeground(INK);
        keys.setFont(words.getFont());
        keys.setLineWrap(true);
        keys.setWrapStyleWord(true);
        keys.setEditable(false);
        keys.setFocusable(false);
        add(words, BorderLayout.CENTER);
        add(scale, BorderLayout.EAST);
        add(keys, BorderLayout.SOUTH);
    }

    private static JLabel label() {
        JLabel label = new JLabel(" ");
        label.setForeground(INK);
        label.setFont(label.getFont().deriveFont(Font.PLAIN));
        return label;
    }

    /** As wide as the picture is, and as high as the keys need in that width; until it is known, in the least one. */
    @Override
    public Dimension getPreferredSize() {
        int width = Math.max(PreviewWindow.LEAST_VIEW.width, getWidth()) - 2 * MARGIN;
        return new Dimension(0, getInsets().top + words.getPreferredSize().height + MessagePanel.heightIn(width, keys)
            + getInsets().bottom);
    }

    void say(String sentence, double newScale, String whatKeysDo) {
        words.setText(sentence.isEmpty() ? " " : sentence);
        scale.setText(String.format(Locale.ROOT, "%.0f %%", 100 * newScale));
        if (!whatKeysDo.equals(keys.getText())) {
            keys.setText(whatKeysDo);
        }
    }
}
