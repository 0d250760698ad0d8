package org.sami.spn.host;

import java.util.List;
import java.util.function.Supplier;

/** Keeps nothing but where it is: for sessions of any length that nobody resumes or reads again. */
public final class NoJournal implements InputJournal {
    private long lastIndex;
    private long lastMillis;

    @Override
    public synchronized long lastIndex() {
        return lastIndex;
    }

    @Override
    public synchronized long lastMillis() {
        return lastMillis;
    }

    @Override
    public synchronized void append(List<JournalEntry> batch, Durability durability) {
        if (batch.isEmpty()) {
            return;
        }
        if (batch.get(0).index() != lastIndex + 1) {
            throw new IllegalArgumentException("entry " + (lastIndex + 1) + " expected, not "
                    + batch.get(0).index());
        }
        JournalEntry last = batch.get(batch.size() - 1);
        lastIndex = last.index();
        lastMillis = last.atMillis();
    }

    @Override
    public void offerSnapshot(Supplier<byte[]> state) {
        // Nobody will go on from it.
    }

    @Override
    public void sync() {
        // There is nothing to be kept.
    }

    @Override
    public void close() {
        // There is nothing open.
    }
}
