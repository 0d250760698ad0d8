package org.sami.ui.command;

import java.awt.Dialog;
import java.awt.KeyEventDispatcher;
import java.awt.KeyEventPostProcessor;
import java.awt.KeyboardFocusManager;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.KeyStroke;
import javax.swing.text.JTextComponent;

/**
 * Runs commands by their keys in all windows of the process. A component that has a use for a key comes first, but for commands that are
 * {@linkplain Command#always always} there; while a modal dialog is open only those are. On the event thread.
 */
public final class CommandKeys implements AutoCloseable {
    private final CommandRegistry commands;
    private final Consumer<String> refused;
    private final KeyEventDispatcher before = this::beforeComponents;
    private final KeyEventPostProcessor after = this::afterComponents;
    private final OnePress press = new OnePress();
    private Optional<KeyStroke> last = Optional.empty();
    private boolean again; // the key that is struck now is the one before, struck at once

    private CommandKeys(CommandRegistry commands, Consumer<String> refused) {
        this.commands = commands;
        this.refused = refused;
    }

    /** Lets keys run commands until the result is closed; the key of one that cannot be run does nothing. */
    public static CommandKeys install(CommandRegistry commands) {
        return install(commands, refusal -> {});
    }

    /**
     * Lets keys run commands until the result is closed.
     *
     * @param refused receives, in one line, why the key of a command did nothing
     */
    public static CommandKeys install(CommandRegistry commands, Consumer<String> refused) {
        CommandKeys keys = new CommandKeys(commands, refused);
        KeyboardFocusManager manager = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        manager.addKeyEventDispatcher(keys.before);
        manager.addKeyEventPostProcessor(keys.after);
        return keys;
    }

    private boolean beforeComponents(KeyEvent event) {
        if (isStruck(event)) {
            KeyStroke stroke = KeyStroke.getKeyStrokeForEvent(event);
            boolean same = last.equals(Optional.of(stroke));
            again = !press.isOwn() && same;
            last = Optional.of(stroke);
        }
        Optional<Command> command = commandOf(event).filter(Command::isAlways);
        command.ifPresent(this::run);
        return command.isPresent();
    }

    /** Runs a command, or says why it does nothing: a key that is silent leaves it open whether it was taken. */
    private void run(Command command) {
        Optional<String> whyNot = command.whyNot();
        if (whyNot.isPresent()) {
            refused.accept(command.keyText() + ", " + command.title() + ": " + whyNot.get());
        }
        command.run();
    }

    private boolean afterComponents(KeyEvent event) {
        if (event.isConsumed()
                || isModal(KeyboardFocusManager.getCurrentKeyboardFocusManager().getActiveWindow())) {
            return false;
        }
        boolean typing = event.getComponent() instanceof JTextComponent;
        Optional<Command> command = commandOf(event).filter(one -> !typing || !one.isTyped());
        command.filter(one -> !one.isOnce() || !again).ifPresent(this::run);
        return command.isPresent();
    }

    /** Whether a key goes down that does not only change what others mean. */
    private static boolean isStruck(KeyEvent event) {
        int key = event.getKeyCode();
        return event.getID() == KeyEvent.KEY_PRESSED
                && key != KeyEvent.VK_ALT
                && key != KeyEvent.VK_CONTROL
                && key != KeyEvent.VK_SHIFT
                && key != KeyEvent.VK_META
                && key != KeyEvent.VK_ALT_GRAPH;
    }

    private Optional<Command> commandOf(KeyEvent event) {
        return event.getID() == KeyEvent.KEY_PRESSED
                ? commands.ofKey(KeyStroke.getKeyStrokeForEvent(event))
                : Optional.empty();
    }

    private static boolean isModal(Window window) {
        return window instanceof Dialog dialog && dialog.isModal();
    }

    @Override
    public void close() {
        KeyboardFocusManager manager = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        manager.removeKeyEventDispatcher(before);
        manager.removeKeyEventPostProcessor(after);
    }
}
