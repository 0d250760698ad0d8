package org.sami.dreamm.canvas;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.geom.Point2D;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.text.JTextComponent;
import org.sami.palette.SemanticColor;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.net.NetView;

/** Lets the author write on the net where the text stands. Enter keeps it (in a note Ctrl+Enter), as does leaving it; Escape does not. */
final class WriteInPlace {
    private static final int LEAST_WIDTH = 180;
    private static final int HEIGHT = 34;

    private final NetView view;
    private Optional<JTextComponent> open = Optional.empty();
    private Consumer<String> kept = text -> {};

    WriteInPlace(NetView view) {
        this.view = view;
    }

    /** Writes one line below a vertex. */
    void line(Vertex vertex, String text, Consumer<String> then) {
        JTextField field = new JTextField(text);
        field.setName("net-name");
        field.getAccessibleContext().setAccessibleName("Name of the vertex");
        Point2D at = view.pixel(vertex.centre().x(), vertex.box().maxY());
        int width = Math.max(Look.px(LEAST_WIDTH), field.getPreferredSize().width + Look.px(24));
        begin(
                field,
                new Rectangle((int) at.getX() - width / 2, (int) at.getY() + 2, width, Look.px(HEIGHT)),
                "ENTER",
                then);
    }

    /** Writes one line at the head of a frame. */
    void line(DrawingBox head, String text, Consumer<String> then) {
        JTextField field = new JTextField(text);
        field.setName("net-frame-title");
        field.getAccessibleContext().setAccessibleName("Title of the frame");
        Point2D at = view.pixel(head.x(), head.y());
        int width = Math.max(
                Look.px(LEAST_WIDTH), (int) (view.pixel(head.maxX(), head.y()).getX() - at.getX()) / 2);
        begin(field, new Rectangle((int) at.getX(), (int) at.getY(), width, Look.px(HEIGHT)), "ENTER", then);
    }

    /** Writes paragraphs in a box of the drawing. */
    void paragraphs(DrawingBox box, String text, Consumer<String> then) {
        JTextArea area = new JTextArea(text);
        area.setName("net-note");
        area.setLineWrap(true);
        area.setWrapStyleWord(true);
        area.getAccessibleContext().setAccessibleName("Text of the note");
        area.setToolTipText("Ctrl+Enter keeps the text, Escape does not");
        LookColors.border(
                area,
                () -> BorderFactory.createCompoundBorder(
                        BorderFactory.createLineBorder(SemanticColor.ACCENT.get(), 2),
                        BorderFactory.createEmptyBorder(6, 6, 6, 6)));
        Point2D at = view.pixel(box.x(), box.y());
        Point2D to = view.pixel(box.maxX(), box.maxY());
        int width = Math.max(Look.px(260), (int) (to.getX() - at.getX()));
        int height = Math.max(Look.px(90), (int) (to.getY() - at.getY()));
        begin(area, new Rectangle((int) at.getX(), (int) at.getY(), width, height), "ctrl ENTER", then);
    }

    private void begin(JTextComponent text, Rectangle bounds, String keeping, Consumer<String> then) {
        end();
        kept = then;
        open = Optional.of(text);
        text.setFont(Fonts.text());
        Dimension room = view.getSize();
        text.setBounds(
                Math.max(0, Math.min(bounds.x, room.width - bounds.width)),
                Math.max(0, Math.min(bounds.y, room.height - bounds.height)),
                bounds.width,
                bounds.height);
        bind(text, keeping, () -> {
            end();
            view.canvas().requestFocusInWindow();
        });
        bind(text, "ESCAPE", () -> {
            kept = unchanged -> {};
            end();
            view.canvas().requestFocusInWindow();
        });
        text.addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent e) {
                if (!e.isTemporary()) {
                    end();
                }
            }
        });
        view.add(text, 0);
        text.selectAll();
        text.requestFocusInWindow();
        view.repaint();
    }

    private static void bind(JComponent text, String key, Runnable action) {
        text.getInputMap().put(KeyStroke.getKeyStroke(key), key);
        text.getActionMap().put(key, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent e) {
                action.run();
            }
        });
    }

    /** Keeps what was written, where something is being written. */
    void end() {
        open.ifPresent(text -> {
            open = Optional.empty();
            view.remove(text);
            view.repaint();
            kept.accept(text.getText().strip());
        });
    }
}
