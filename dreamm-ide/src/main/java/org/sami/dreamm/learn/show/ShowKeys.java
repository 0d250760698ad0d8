package org.sami.dreamm.learn.show;

import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.JRootPane;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandRegistry;

/**
 * The keys while something is shown: those of its commands, Space, the arrows and Escape, those of the window's look and of its end, and Tab among the buttons.
 * All others do nothing, so that nobody edits the copy by mistake.
 */
final class ShowKeys implements KeyEventDispatcher {
    private static final List<String> WINDOW = List.of("end", "theme-", "scale-", "rows-high", "show-");

    private final CommandRegistry registry;
    private final JRootPane root;
    private final ShowOverlay overlay;
    private final Map<KeyStroke, Command> own;

    ShowKeys(CommandRegistry registry, ShowCommands commands, JRootPane root, ShowOverlay overlay) {
        this.registry = registry;
        this.root = root;
        this.overlay = overlay;
        own = Map.of(
                KeyStroke.getKeyStroke("SPACE"), commands.play(),
                KeyStroke.getKeyStroke("RIGHT"), commands.forward(),
                KeyStroke.getKeyStroke("LEFT"), commands.back(),
                KeyStroke.getKeyStroke("ESCAPE"), commands.stop());
    }

    void install() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(this);
    }

    void remove() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(this);
    }

    @Override
    public boolean dispatchKeyEvent(KeyEvent event) {
        if (event.isConsumed() || SwingUtilities.getRootPane(event.getComponent()) != root) {
            return false;
        }
        boolean inBar = SwingUtilities.isDescendingFrom(event.getComponent(), overlay);
        KeyStroke stroke = KeyStroke.getKeyStrokeForEvent(event);
        Optional<Command> command = Optional.ofNullable(own.get(stroke)).or(() -> window(stroke));
        if (event.getID() == KeyEvent.KEY_PRESSED && command.isPresent()) {
            command.get().run();
            return true;
        }
        boolean amongButtons = event.getKeyCode() == KeyEvent.VK_TAB || event.getKeyCode() == KeyEvent.VK_ENTER;
        return !(inBar && amongButtons);
    }

    private Optional<Command> window(KeyStroke stroke) {
        return registry.ofKey(stroke).filter(command -> WINDOW.stream().anyMatch(command.id()::startsWith));
    }
}
