package org.sami.ui.dock;

import java.awt.Dimension;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.sami.ui.look.Look;

/**
 * The arrangements that a program has for its panels: one for windows with room, one with fewer panels beside one another for small windows
 * and large letters. Immutable.
 *
 * @param least how large the area of the panels has to be for the roomy one, in pixels at 100 %
 */
public record Arrangements(Arrangement roomy, Arrangement compact, Dimension least) {
    public Arrangements {
        Objects.requireNonNull(roomy, "roomy");
        Objects.requireNonNull(compact, "compact");
        Objects.requireNonNull(least, "least");
    }

    /** The same arrangement at any size. */
    public static Arrangements of(Arrangement only) {
        return new Arrangements(only, only, new Dimension());
    }

    /** Which of them fits an area of a size in pixels, at the scale in force. */
    public Arrangement fitting(Dimension size) {
        boolean room = size.width >= Look.px(least.width) && size.height >= Look.px(least.height);
        return room ? roomy : compact;
    }

    /** The same where some panels are missing. */
    Arrangements of(Set<String> present) {
        return new Arrangements(roomy.of(present), compact.of(present), least);
    }

    List<Arrangement> all() {
        return List.of(roomy, compact);
    }
}
