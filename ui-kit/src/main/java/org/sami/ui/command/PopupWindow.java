package org.sami.ui.command;

import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.awt.event.WindowFocusListener;
import java.util.function.Function;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.KeyStroke;
import org.sami.ui.look.Look;

/** A bare window over another that closes with Escape and when it loses the focus; it is never modal, so that nothing waits for it. */
public final class PopupWindow {
    private static final int FROM_TOP = 96;

    private PopupWindow() {}

    /**
     * Opens it.
     *
     * @param content is made with what closes the window
     */
    public static void open(Window owner, String title, Function<Runnable, JComponent> content) {
        JDialog dialog = new JDialog(owner, title);
        dialog.setName("popup-window");
        dialog.setUndecorated(true);
        dialog.setContentPane(content.apply(dialog::dispose));
        dialog.getRootPane()
                .registerKeyboardAction(
                        e -> dialog.dispose(),
                        KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0),
                        JComponent.WHEN_IN_FOCUSED_WINDOW);
        dialog.pack();
        dialog.setLocation(owner.getX() + (owner.getWidth() - dialog.getWidth()) / 2, owner.getY() + Look.px(FROM_TOP));
        dialog.addWindowFocusListener(new WindowFocusListener() {
            @Override
            public void windowGainedFocus(WindowEvent e) {
                // it has it to take input
            }

            @Override
            public void windowLostFocus(WindowEvent e) {
                dialog.dispose();
            }
        });
        dialog.setVisible(true);
    }
}
