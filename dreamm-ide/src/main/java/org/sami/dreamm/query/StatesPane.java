package org.sami.dreamm.query;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.OptionalInt;
import javax.swing.AbstractAction;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import org.sami.palette.SemanticColor;
import org.sami.picture.GraphicsCanvas;
import org.sami.picture.states.StateGraphPainter;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.states.StateGraphDrawing;
import org.sami.ui.look.Look;

/** The graph of states, to be clicked: a state or an arrow is selected; left and right select the state before and after. On the event thread. */
final class StatesPane extends JPanel {
    private static final int MARGIN = 16;

    private final transient StatesOfPlan states;
    private boolean isNew = true;

    StatesPane(StatesOfPlan states) {
        this.states = states;
        setName("states-pane");
        setFocusable(true);
        getAccessibleContext().setAccessibleName("Graph of states");
        addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                requestFocusInWindow();
                press(e.getX(), e.getY());
            }
        });
        key("LEFT", -1);
        key("RIGHT", 1);
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent e) {
                seeStart();
            }
        });
        states.addListener(() -> {
            isNew |= states.states().isEmpty();
            revalidate();
            repaint();
        });
    }

    /** Scrolls to the initial state of a graph that is shown for the first time. */
    private void seeStart() {
        if (isNew && states.states().isPresent()) {
            isNew = false;
            StateGraphDrawing drawing = states.states().get().drawing();
            scrollRectToVisible(area(drawing, drawing.boxes().get(0).area()));
        }
    }

    private void key(String key, int step) {
        getInputMap().put(KeyStroke.getKeyStroke(key), key);
        getActionMap().put(key, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent e) {
                go(step);
            }
        });
    }

    private void go(int step) {
        states.states().ifPresent(shown -> {
            int next = states.state().orElse(step > 0 ? -1 : shown.markings().size()) + step;
            if (next >= 0 && next < shown.markings().size()) {
                states.selectState(next);
                scrollRectToVisible(
                        area(shown.drawing(), shown.drawing().boxes().get(next).area()));
            }
        });
    }

    private static double scale() {
        return Look.scalePercent() / 100.0;
    }

    /** Where a box of the drawing lies in the component. */
    private static Rectangle area(StateGraphDrawing drawing, DrawingBox box) {
        double scale = scale();
        DrawingBox all = drawing.bounds();
        return new Rectangle(
                (int) ((box.x() - all.x()) * scale),
                (int) ((box.y() - all.y()) * scale),
                (int) (box.width() * scale) + 2 * MARGIN,
                (int) (box.height() * scale) + 2 * MARGIN);
    }

    private void press(int x, int y) {
        states.states().ifPresent(shown -> {
            DrawingBox all = shown.drawing().bounds();
            double atX = (x - MARGIN) / scale() + all.x();
            double atY = (y - MARGIN) / scale() + all.y();
            OptionalInt state = shown.drawing().stateAt(atX, atY);
            if (state.isPresent()) {
                states.selectState(state.getAsInt());
            } else {
                shown.drawing().arrowAt(atX, atY).ifPresent(states::selectArrow);
            }
        });
    }

    @Override
    public Dimension getPreferredSize() {
        return states.states()
                .map(shown -> area(shown.drawing(), shown.drawing().bounds()).getSize())
                .orElse(new Dimension(MARGIN, MARGIN));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setColor(SemanticColor.NET_CANVAS.in(Look.theme()));
        g.fillRect(0, 0, getWidth(), getHeight());
        states.states().ifPresent(shown -> {
            g.translate(MARGIN, MARGIN);
            g.scale(scale(), scale());
            DrawingBox all = shown.drawing().bounds();
            g.translate(-all.x(), -all.y());
            new StateGraphPainter(new GraphicsCanvas(g), Look.theme())
                    .paint(shown.drawing(), states.state(), states.arrow());
        });
        g.dispose();
    }
}
