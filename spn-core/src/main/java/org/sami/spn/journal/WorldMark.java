package org.sami.spn.journal;

import java.util.Objects;

/** What a simulated world said of itself after an entry, to be compared when the world is built again. */
public record WorldMark(long index, String text) {
    public WorldMark {
        Objects.requireNonNull(text, "text");
    }
}
