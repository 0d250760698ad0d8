package org.sami.spn.journal;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.List;

/**
 * When a journal takes a snapshot, and which it gives up: the newest stay, and of the older ones every how-many-th. A large one waits until the entries
 * since the last are several times as long as that was, so that snapshots are never most of what is written (docs/decisions 0570).
 */
final class SnapshotSchedule {
    /** Bytes of a snapshot that waits for nothing but its number of entries. */
    private static final int SMALL = 64 * 1024;
    /** Bytes of entries between large snapshots for each byte of a snapshot. */
    private static final int ENTRIES_PER_SNAPSHOT = 8;

    private final int every;
    private final Deque<Long> snapshots;
    private long last;
    private long keptForGood;
    private long attempted;
    private long lastBytes;
    private long bytesSince;

    /**
     * Of a journal that was opened.
     *
     * @param indexes of the snapshots that are in it, in order
     */
    SnapshotSchedule(JournalOptions options, Collection<Long> indexes) {
        every = options.snapshotEvery();
        snapshots = new ArrayDeque<>(indexes);
        last = snapshots.isEmpty() ? 0 : snapshots.getLast();
    }

    boolean isDue(long index) {
        return every > 0
                && index - last >= every
                && (lastBytes <= SMALL || bytesSince >= lastBytes * ENTRIES_PER_SNAPSHOT);
    }

    /** Entries of so many bytes were written. */
    void grew(long bytes) {
        bytesSince += bytes;
    }

    /** One of so many bytes was written; gives those that are to be deleted with it. */
    List<Long> written(long index, int bytes) {
        attempted = bytes;
        snapshots.add(index);
        return snapshots.size() > JournalOptions.NEWEST_SNAPSHOTS ? thinOut() : List.of();
    }

    /** It is in the journal. */
    void committed(long index) {
        last = index;
        lastBytes = attempted;
        bytesSince = 0;
    }

    /** Which snapshots between the newest and the last that stays for good are given up. */
    private List<Long> thinOut() {
        List<Long> dropped = new ArrayList<>();
        long staying = keptForGood;
        while (snapshots.size() > JournalOptions.NEWEST_SNAPSHOTS) {
            long oldest = snapshots.removeFirst();
            if (oldest - staying >= (long) every * JournalOptions.KEPT_SNAPSHOT) {
                staying = oldest;
            } else {
                dropped.add(oldest);
            }
        }
        keptForGood = staying;
        return dropped;
    }
}
