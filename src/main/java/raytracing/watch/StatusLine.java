package raytracing.watch;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.util.Locale;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** A line under the picture: the pixel under the pointer, or what can be done, and the scale. */
final class StatusLine extends JPanel {
    private static final long serialVersionUID = 1;
    private static final Color PAPER = new Color(0x1c1d1f);
    private static final Color INK = new Color(0xb8bbc0);
    private static final int MARGIN = 6;

    private final transient JLabel words = label();
    private final transient JLabel scale = label();

    StatusLine() {
        super(new BorderLayout(MARGIN, 0));
        setBackground(PAPER);
        setBorder(BorderFactory.createEmptyBorder(2, MARGIN, 2, MARGIN));
        add(words, BorderLayout.CENTER);
        add(scale, BorderLayout.EAST);
    }

    private static JLabel label() {
        JLabel label = new JLabel(" ");
        label.setForeground(INK);
        label.setFont(label.getFont().deriveFont(Font.PLAIN));
        return label;
    }

    /** As wide as the picture is: the sentence is cut off where it is longer. */
    @Override
    public Dimension getPreferredSize() {
        return new Dimension(0, super.getPreferredSize().height);
    }

    void say(String sentence) {
        words.setText(sentence);
    }

    void say(double newScale) {
        scale.setText(String.format(Locale.ROOT, "%.0f %%", 100 * newScale));
    }
}
