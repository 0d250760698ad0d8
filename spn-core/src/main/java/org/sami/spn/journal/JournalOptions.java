package org.sami.spn.journal;

/**
 * How a journal is written. None of it changes what is read.
 *
 * @param snapshotEvery a snapshot of the state after so many entries, a large one after more (docs/decisions 0570); 0 = none
 * @param syncWithinMillis after how many milliseconds an entry survives the loss of power; 0 = only by an explicit sync
 * @param syncCommands whether a batch that asks for it survives the loss of power before its effects leave; false only
 *     where nobody can lose power, as in a simulated session
 * @param pageBytes size of SQLite's pages, a power of 2 from 512 to 65,536
 * @param checkpointPages after how many pages the write-ahead log is folded into the file; 0 = only at the end
 */
public record JournalOptions(
        int snapshotEvery, int syncWithinMillis, boolean syncCommands, int pageBytes, int checkpointPages) {
    /** What a session in the field uses. */
    public static final JournalOptions DEFAULT = new JournalOptions(1000, 100, true, 4096, 4000);

    /** So many snapshots are kept in any case: to these a resume and those who look back at once go. */
    static final int NEWEST_SNAPSHOTS = 10;

    /** Of the older ones every how-many-th is kept; between them the entries are gone through again. */
    static final int KEPT_SNAPSHOT = 20;

    public JournalOptions {
        if (snapshotEvery < 0 || syncWithinMillis < 0 || checkpointPages < 0) {
            throw new IllegalArgumentException("Not negative: snapshotEvery " + snapshotEvery + ", syncWithinMillis "
                    + syncWithinMillis + ", checkpointPages " + checkpointPages);
        }
        if (pageBytes < 512 || pageBytes > 65_536 || Integer.bitCount(pageBytes) != 1) {
            throw new IllegalArgumentException("Not a size of pages: " + pageBytes);
        }
    }

    /** The same with another distance of snapshots. */
    public JournalOptions withSnapshotEvery(int entries) {
        return new JournalOptions(entries, syncWithinMillis, syncCommands, pageBytes, checkpointPages);
    }

    /** The same, never waiting for the disk: survives the death of the process and no more. */
    public JournalOptions withoutSync() {
        return new JournalOptions(snapshotEvery, 0, false, pageBytes, checkpointPages);
    }

    /** The same with other pages. */
    public JournalOptions withPages(int bytes, int checkpointAfter) {
        return new JournalOptions(snapshotEvery, syncWithinMillis, syncCommands, bytes, checkpointAfter);
    }

    /** Whether the log is folded beside what is written: after each sync that comes by itself. */
    boolean checkpointsBeside() {
        return checkpointPages > 0 && syncWithinMillis > 0;
    }

    /** Whether the loss of power is cared for at all. */
    boolean everSyncs() {
        return syncCommands || syncWithinMillis > 0;
    }
}
