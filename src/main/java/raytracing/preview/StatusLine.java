package raytracing.preview;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.util.Locale;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;

/** The lines under the picture: the pixel under the pointer and the scale, then what the keys do, broken at the width. */
final class StatusLine extends JPanel {
    private static final long serialVersionUID = 1;
    private static final Color PAPER = new Color(0x1c1d1f);
    private static final Color INK = new Color(0xb8bbc0);
    private static final int MARGIN = 6;

    private final transient JLabel words = label();
    private final transient JLabel scale = label();
    private final transient JTextArea keys = MessagePanel.wrapped(PAPER, INK);

    StatusLine() {
        super(new BorderLayout(MARGIN, 0));
        setBackground(PAPER);
        setBorder(BorderFactory.createEmptyBorder(2, MARGIN, 2, MARGIN));
        keys.setFont(words.getFont());
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

    /** As high as the text about the keys needs at this width; before the width is known, at the least width of a view. */
    @Override
    public Dimension getPreferredSize() {
        int width = Math.max(PictureView.LEAST_SIZE.width, getWidth()) - 2 * MARGIN;
        return new Dimension(0, getInsets().top + words.getPreferredSize().height + MessagePanel.heightIn(width, keys)
            + getInsets().bottom);
    }

    void show(String sentence, double newScale, String whatKeysDo) {
        words.setText(sentence.isEmpty() ? " " : sentence);
        scale.setText(String.format(Locale.ROOT, "%.0f %%", 100 * newScale));
        if (!whatKeysDo.equals(keys.getText())) {
            keys.setText(whatKeysDo);
        }
    }
}
