package org.sami.spn.host;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/**
 * A journal that lives as long as its object: for tests, and for runs that nobody resumes. Durable against nothing.
 */
public final class MemoryJournal implements InputJournal {
    private final List<JournalEntry> entries = new ArrayList<>();

    @Override
    public synchronized long lastIndex() {
        return entries.size();
    }

    @Override
    public synchronized long lastMillis() {
        return entries.isEmpty() ? 0 : entries.get(entries.size() - 1).atMillis();
    }

    @Override
    public synchronized void append(List<JournalEntry> batch, Durability durability) {
        long expected = lastIndex();
        for (JournalEntry entry : batch) {
            expected++;
            if (entry.index() != expected) {
                throw new IllegalArgumentException("entry " + expected + " expected, not " + entry.index());
            }
        }
        entries.addAll(batch);
    }

    @Override
    public void offerSnapshot(Supplier<byte[]> state) {
        // The entries are all here: nothing would be gained.
    }

    @Override
    public void sync() {
        // There is nothing that memory could be made to survive.
    }

    @Override
    public void close() {
        // The entries stay readable.
    }

    /** All entries so far, in order. */
    public synchronized List<JournalEntry> entries() {
        return List.copyOf(entries);
    }
}
