package org.sami.crw.gui.boat;

import java.awt.Color;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Optional;
import java.util.function.UnaryOperator;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;

/**
 * A stick on the screen: dragged up and down it is thrust, left and right the rudder; let go it stands in the middle, and the boat stands. Tells
 * how it stands as parts of full deflection. Only a press takes it: once it was let go for its holder it has to be pressed anew.
 */
final class StickView extends JPanel {
    private static final int SIZE = 148;
    private static final int KNOB = 22;

    private final transient Driver driver;
    private final UnaryOperator<String> words;
    private boolean grasped;
    private double thrust;
    private double rudder;

    /** Who drives by the stick. */
    interface Driver {
        /** Why it can be moved by nobody now; empty where it can. */
        Optional<String> whyNot();

        /** The stick is pressed. Gives whether something is driven by it from now on. */
        boolean grasp();

        /** Up is positive thrust, right is positive rudder; -1 to 1 each. */
        void stands(double thrust, double rudder);
    }

    /**
     * A stick in the middle.
     *
     * @param driver is told where it stands
     * @param words puts the word for the session's robots into a text about boats
     */
    StickView(Driver driver, UnaryOperator<String> words) {
        this.words = words;
        this.driver = driver;
        setName("boat-stick");
        setOpaque(false);
        setToolTipText("");
        getAccessibleContext()
                .setAccessibleName(words.apply("Stick: up and down is thrust, left and right the rudder"));
        getAccessibleContext().setAccessibleDescription(words.apply("With keys: Drive by hand, then the arrow keys"));
        setCursor(Cursor.getPredefinedCursor(Cursor.HAND_CURSOR));
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                if (SwingUtilities.isLeftMouseButton(e)) {
                    grasped = driver.grasp();
                    drag(e);
                }
            }

            @Override
            public void mouseDragged(MouseEvent e) {
                drag(e);
            }

            @Override
            public void mouseReleased(MouseEvent e) {
                grasped = false;
                stand(0, 0);
            }
        };
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
    }

    /** Puts it into the middle whoever holds it, who has to press it anew; the driver knows. */
    void letGo() {
        grasped = false;
        thrust = 0;
        rudder = 0;
        repaint();
    }

    private void drag(MouseEvent e) {
        if (grasped && SwingUtilities.isLeftMouseButton(e)) {
            double reach = reach();
            stand(part((getHeight() / 2.0 - e.getY()) / reach), part((e.getX() - getWidth() / 2.0) / reach));
        }
    }

    private static double part(double value) {
        return Math.max(-1, Math.min(1, value));
    }

    private double reach() {
        return Math.max(1, Math.min(getWidth(), getHeight()) / 2.0 - Look.px(KNOB));
    }

    private void stand(double nextThrust, double nextRudder) {
        thrust = nextThrust;
        rudder = nextRudder;
        repaint();
        driver.stands(thrust, rudder);
    }

    @Override
    public String getToolTipText(MouseEvent event) {
        return words.apply(driver.whyNot()
                .map(why -> "Stick: " + why)
                .orElse("Drag: up and down is thrust, left and right the rudder"));
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Look.px(SIZE), Look.px(SIZE));
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(Look.px(SIZE * 2 / 3), Look.px(SIZE * 2 / 3));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        boolean off = driver.whyNot().isPresent();
        int middleX = getWidth() / 2;
        int middleY = getHeight() / 2;
        int radius = (int) reach() + Look.px(KNOB) - 2;
        g.setColor(SemanticColor.SURFACE_RAISED.get());
        g.fillOval(middleX - radius, middleY - radius, 2 * radius, 2 * radius);
        Color line = (off ? SemanticColor.DISABLED : SemanticColor.MUTED).get();
        g.setColor(line);
        g.drawOval(middleX - radius, middleY - radius, 2 * radius, 2 * radius);
        g.drawLine(middleX - radius, middleY, middleX + radius, middleY);
        g.drawLine(middleX, middleY - radius, middleX, middleY + radius);
        int knob = Look.px(KNOB);
        int x = middleX + (int) Math.round(rudder * reach());
        int y = middleY - (int) Math.round(thrust * reach());
        g.setColor((off ? SemanticColor.DISABLED : SemanticColor.ACCENT).get());
        g.fillOval(x - knob, y - knob, 2 * knob, 2 * knob);
        g.setColor(SemanticColor.ON_ACCENT.get());
        g.setFont(Fonts.strong());
        String arrow = thrust > 0.1 ? "▲" : thrust < -0.1 ? "▼" : rudder > 0.1 ? "▶" : rudder < -0.1 ? "◀" : "";
        g.drawString(
                arrow,
                x - g.getFontMetrics().stringWidth(arrow) / 2,
                y + (g.getFontMetrics().getAscent() - g.getFontMetrics().getDescent()) / 2);
        g.dispose();
    }
}
