package org.sami.crw.sim.resume;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.JournalException;
import org.sami.spn.journal.JournalReader;

/** The entries that earlier processes of a run wrote, of which only those around the last one asked for are in memory. */
final class PastEntries implements AutoCloseable {
    private static final int BLOCK = 1000;

    private final JournalReader reader;
    private final List<JournalEntry> block = new ArrayList<>();

    /** Entries of a journal, which is closed with this. */
    PastEntries(JournalReader reader) {
        this.reader = reader;
    }

    /** How many there are. */
    long size() {
        return reader.lastIndex();
    }

    /** The time of the last; 0 where there is none. */
    long lastMillis() {
        return reader.lastMillis();
    }

    /** One entry, counted from 1; asked for in order. */
    JournalEntry get(long index) throws JournalException {
        if (block.isEmpty()
                || index < block.get(0).index()
                || index > block.get(block.size() - 1).index()) {
            block.clear();
            reader.entries(index, Math.min(size(), index + BLOCK - 1), block::add);
        }
        return block.get((int) (index - block.get(0).index()));
    }

    @Override
    public void close() throws JournalException {
        reader.close();
    }
}
