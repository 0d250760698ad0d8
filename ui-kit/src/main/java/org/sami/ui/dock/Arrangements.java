package org.sami.ui.dock;

import java.awt.Dimension;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.sami.ui.look.Look;

/**
 * The arrangements that a program has for its panels: one for windows with room, one with fewer panels side by side for small windows
 * and large letters, one with fewer still for the smallest. Immutable.
 *
 * @param leastRoomy how large the area of the panels has to be for the roomy one, in pixels at 100 %
 * @param leastCompact how large it has to be for the compact one
 */
public record Arrangements(
        Arrangement roomy, Arrangement compact, Arrangement tight, Dimension leastRoomy, Dimension leastCompact) {
    public Arrangements {
        Objects.requireNonNull(roomy, "roomy");
        Objects.requireNonNull(compact, "compact");
        Objects.requireNonNull(tight, "tight");
        Objects.requireNonNull(leastRoomy, "leastRoomy");
        Objects.requireNonNull(leastCompact, "leastCompact");
    }

    /** Which of them fits an area of a size in pixels, at the scale in force. */
    public Arrangement fitting(Dimension size) {
        return hasRoom(size, leastRoomy) ? roomy : hasRoom(size, leastCompact) ? compact : tight;
    }

    private static boolean hasRoom(Dimension size, Dimension least) {
        return size.width >= Look.px(least.width) && size.height >= Look.px(least.height);
    }

    /** The same where some panels are missing. */
    Arrangements of(Set<String> present) {
        return new Arrangements(roomy.of(present), compact.of(present), tight.of(present), leastRoomy, leastCompact);
    }

    /** Whether panels are folded at first in any of them: then those that are closed are folded as well. */
    boolean fold() {
        return all().stream().anyMatch(Arrangement::folds);
    }

    /** The panel that fills the window first, where there is much room. */
    String largest() {
        return roomy.first();
    }

    List<Arrangement> all() {
        return List.of(roomy, compact, tight);
    }
}
