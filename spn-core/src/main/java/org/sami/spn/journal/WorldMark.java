package org.sami.spn.journal;

import java.util.Objects;

/** The state of a simulated world after an entry, for comparison when the world is built again. */
public record WorldMark(long index, String text) {
    public WorldMark {
        Objects.requireNonNull(text, "text");
    }
}
