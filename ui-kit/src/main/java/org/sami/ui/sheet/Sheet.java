package org.sami.ui.sheet;

import java.awt.Component;
import java.util.Objects;
import java.util.Optional;
import javax.swing.JComponent;

/**
 * What a window shows over its panels.
 *
 * @param name of the component
 * @param title in words; empty text for none, and no button that closes it
 * @param over what it belongs to, over whose middle it lies; empty = the window's top
 * @param passing whether it closes when the focus leaves it, as a search does
 * @param closed is run once, when it was closed for any reason
 */
public record Sheet(
        String name, String title, JComponent content, Optional<Component> over, boolean passing, Runnable closed) {
    public Sheet {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(title, "title");
        Objects.requireNonNull(content, "content");
        Objects.requireNonNull(over, "over");
        Objects.requireNonNull(closed, "closed");
    }

    /** One that stays until it is closed, at the window's top. */
    public Sheet(String name, String title, JComponent content) {
        this(name, title, content, Optional.empty(), false, () -> {});
    }

    /** The same, over the middle of a component. */
    public Sheet over(Component component) {
        return new Sheet(name, title, content, Optional.of(component), passing, closed);
    }

    /** The same, closed when the focus leaves it. */
    public Sheet passing(boolean passes) {
        return new Sheet(name, title, content, over, passes, closed);
    }

    /** The same, with a listener that is called when it was closed. */
    public Sheet whenClosed(Runnable told) {
        return new Sheet(name, title, content, over, passing, told);
    }
}
