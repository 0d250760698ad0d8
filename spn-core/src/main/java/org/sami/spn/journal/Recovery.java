package org.sami.spn.journal;

import java.util.Objects;
import java.util.Optional;

/**
 * What was found when a journal was opened.
 *
 * @param lastValid the last entry whose checksum, and that of all before it, holds
 * @param damage one sentence on what was wrong with the file behind it; empty where nothing was. A write-ahead log that
 *     ends early is no damage: it is what a crash leaves
 */
public record Recovery(long lastValid, Optional<String> damage) {
    public Recovery {
        Objects.requireNonNull(damage, "damage");
    }
}
