package org.sami.crw.gui.context;

import java.awt.Component;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.awt.event.KeyEvent;
import java.awt.event.KeyListener;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.function.Consumer;

/**
 * Tells when the operator's focus comes to a view or leaves it, and when the operator presses, turns the wheel or types there: plans may
 * be kept from changing a view that is in use (meta-markup Manipulation Component, thesis 5.3). On the event thread.
 */
public final class UseWatch extends MouseAdapter implements FocusListener, KeyListener {
    private final Runnable touched;
    private final Consumer<Boolean> focused;

    private UseWatch(Runnable touched, Consumer<Boolean> focused) {
        this.touched = touched;
        this.focused = focused;
    }

    /**
     * Watches a view from now on.
     *
     * @param view has the focus when the operator works there
     * @param scrolled what the wheel turns: the view, or what scrolls it
     * @param touched is run at the beginning and at the end of each use, after the view itself has answered
     * @param focused is given whether the focus is there
     */
    public static void on(Component view, Component scrolled, Runnable touched, Consumer<Boolean> focused) {
        UseWatch watch = new UseWatch(touched, focused);
        view.addFocusListener(watch);
        view.addKeyListener(watch);
        view.addMouseListener(watch);
        scrolled.addMouseWheelListener(
                watch); // on a view that is scrolled it would keep the wheel from what scrolls it
    }

    @Override
    public void focusGained(FocusEvent e) {
        focused.accept(true);
    }

    @Override
    public void focusLost(FocusEvent e) {
        focused.accept(false);
    }

    @Override
    public void mousePressed(MouseEvent e) {
        touched.run();
    }

    @Override
    public void mouseReleased(MouseEvent e) {
        touched.run();
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent e) {
        touched.run();
    }

    @Override
    public void keyTyped(KeyEvent e) {}

    @Override
    public void keyPressed(KeyEvent e) {
        touched.run();
    }

    @Override
    public void keyReleased(KeyEvent e) {
        touched.run();
    }
}
