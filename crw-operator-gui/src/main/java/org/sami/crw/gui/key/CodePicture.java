package org.sami.crw.gui.key;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.util.Optional;
import javax.swing.JPanel;
import org.sami.crw.cli.key.QrCode;

/** Shows a text as a QR code, black on white in every theme, with modules of whole pixels and the margin that readers need. On the event thread. */
final class CodePicture extends JPanel {
    private static final int SIDE = 300;
    private static final int LEAST_SIDE = 180;

    private String text = "";
    private Optional<QrCode> code = Optional.empty();

    CodePicture(String name, String words) {
        setName(name);
        setOpaque(false);
        getAccessibleContext().setAccessibleName(words);
    }

    /** Shows another text; none for an empty one. */
    void show(String next) {
        if (!next.equals(text)) {
            text = next;
            code = next.isEmpty() ? Optional.empty() : Optional.of(QrCode.of(next));
            getAccessibleContext().setAccessibleDescription(next);
            repaint();
        }
    }

    /** What it shows. */
    String text() {
        return text;
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(UIScale.scale(SIDE), UIScale.scale(SIDE));
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(LEAST_SIDE, LEAST_SIDE);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics g = graphics.create();
        try {
            g.setColor(Color.WHITE);
            int side = Math.min(getWidth(), getHeight());
            g.fillRect((getWidth() - side) / 2, (getHeight() - side) / 2, side, side);
            g.setColor(Color.BLACK);
            code.ifPresent(shown -> paint(g, shown));
        } finally {
            g.dispose();
        }
    }

    private void paint(Graphics g, QrCode shown) {
        int modules = shown.size() + 2 * QrCode.QUIET;
        int pixels = Math.max(1, Math.min(getWidth(), getHeight()) / modules);
        int left = (getWidth() - pixels * shown.size()) / 2;
        int top = (getHeight() - pixels * shown.size()) / 2;
        for (int row = 0; row < shown.size(); row++) {
            for (int column = 0; column < shown.size(); column++) {
                if (shown.isDark(column, row)) {
                    g.fillRect(left + column * pixels, top + row * pixels, pixels, pixels);
                }
            }
        }
    }
}
