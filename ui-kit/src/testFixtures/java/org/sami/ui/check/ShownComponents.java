package org.sami.ui.check;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dialog;
import java.awt.Frame;
import java.awt.KeyboardFocusManager;
import java.awt.Window;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;

/** What the windows of this process show. On the event thread. */
final class ShownComponents {
    private ShownComponents() {}

    /** The first component of a type and a name, or of any name, that fits. */
    static <C extends Component> Optional<C> find(Class<C> type, Optional<String> name, Predicate<C> fit) {
        for (Window window : Window.getWindows()) {
            if (window.isShowing()) {
                Optional<C> found = below(window, type, name, fit);
                if (found.isPresent()) {
                    return found;
                }
            }
        }
        return Optional.empty();
    }

    private static <C extends Component> Optional<C> below(
            Component at, Class<C> type, Optional<String> name, Predicate<C> fit) {
        if (name.map(wanted -> wanted.equals(at.getName())).orElse(true)
                && type.isInstance(at)
                && at.isShowing()
                && fit.test(type.cast(at))) {
            return Optional.of(type.cast(at));
        }
        if (at instanceof Container container) {
            for (Component child : container.getComponents()) {
                Optional<C> found = below(child, type, name, fit);
                if (found.isPresent()) {
                    return found;
                }
            }
        }
        return Optional.empty();
    }

    /** Whether keys come to one of the windows. A window manager gives the keyboard to a window some time after it is shown. */
    static boolean haveTheKeyboardOrAreNone() {
        return KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusedWindow() != null
                || Stream.of(Window.getWindows())
                        .noneMatch(
                                window -> window.isShowing() && (window instanceof Frame || window instanceof Dialog));
    }
}
