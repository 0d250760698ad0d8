package org.sami.spn.host;

import java.util.Objects;
import org.sami.spn.protocol.Input;

/**
 * One input as it was taken in.
 *
 * @param index place in the journal, from 1, without gaps
 * @param atMillis the session's time at which it was taken in; never before that of its predecessor
 */
public record JournalEntry(long index, long atMillis, Input input) {
    public JournalEntry {
        if (index < 1) {
            throw new IllegalArgumentException("entries count from 1, not " + index);
        }
        Objects.requireNonNull(input, "input");
    }
}
