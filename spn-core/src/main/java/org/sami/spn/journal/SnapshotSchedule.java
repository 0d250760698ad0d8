package org.sami.spn.journal;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.List;

/** When a journal takes a snapshot, and which it gives up: the newest stay, and of the older ones every how-many-th. */
final class SnapshotSchedule {
    private final int every;
    private final Deque<Long> snapshots;
    private long last;
    private long keptForGood;

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
        return every > 0 && index - last >= every;
    }

    /** One was written; gives those that are to be deleted with it. */
    List<Long> written(long index) {
        snapshots.add(index);
        return snapshots.size() > JournalOptions.NEWEST_SNAPSHOTS ? thinOut() : List.of();
    }

    /** It is in the journal. */
    void committed(long index) {
        last = index;
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
