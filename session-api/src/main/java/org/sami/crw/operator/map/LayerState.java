package org.sami.crw.operator.map;

import java.util.Objects;
import java.util.Set;

/**
 * Whether a layer is drawn, and why.
 *
 * @param why in words, such as the event whose markup asks for it
 * @param boats of which boats it is drawn, where a markup asks for these only; empty for all
 */
public record LayerState(ShownLayer layer, boolean on, Reason reason, String why, Set<String> boats) {

    /** Who decided. */
    public enum Reason {
        /** Nobody: it is so from the start. */
        DEFAULT,
        /** The markup of an event that goes on. */
        MARKUP,
        /** A person; markup changes nothing then. */
        HAND
    }

    public LayerState {
        Objects.requireNonNull(layer, "layer");
        Objects.requireNonNull(reason, "reason");
        Objects.requireNonNull(why, "why");
        boats = Set.copyOf(boats);
    }

    /** Whether what it shows of a boat is drawn. */
    public boolean shows(String boat) {
        return on && (boats.isEmpty() || boats.contains(boat));
    }
}
