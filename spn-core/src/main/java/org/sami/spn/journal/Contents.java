package org.sami.spn.journal;

import java.util.NavigableMap;
import java.util.Optional;

/**
 * What is true in a journal's file: how far the chain of entries holds, and what is attached to it.
 *
 * @param lastMillis the session's time of the last valid entry; 0 where there is none
 * @param lastChecksum the chain's end: of the last valid entry, or of the header
 * @param snapshots checksum of the entry that a snapshot follows, by index; only those at or before the last valid entry
 * @param marks likewise
 * @param damage what is wrong behind the last valid entry
 */
record Contents(
        JournalHeader header,
        long lastValid,
        long lastMillis,
        Checksum lastChecksum,
        NavigableMap<Long, Checksum> snapshots,
        NavigableMap<Long, Checksum> marks,
        Optional<String> damage) {}
