package org.sami.spn.journal;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.JournalException;

/** Copies what is true of a journal to another place: header, entries, marks, snapshots and telemetry. */
public final class JournalCopy {
    private static final int BATCH = 1000;

    private final JournalReader from;
    private final StoredJournal to;
    private final TreeMap<Long, String> marks = new TreeMap<>();
    private final List<JournalEntry> batch = new ArrayList<>();
    private Optional<IOException> failure = Optional.empty();

    private JournalCopy(JournalReader from, StoredJournal to) throws JournalException {
        this.from = from;
        this.to = to;
        from.marks().forEach(mark -> marks.put(mark.index(), mark.text()));
    }

    /**
     * Copies a journal.
     *
     * @param from its reader
     * @param to where no journal is yet
     * @return the checksum of the copy, equal to that of the journal
     * @throws IOException if one cannot be read or the other not be written, or the copy is not equal: then it is not to be used
     */
    public static String copy(JournalReader from, JournalAddress to) throws IOException {
        try (StoredJournal written = to.create(from.header(), JournalOptions.DEFAULT)) {
            new JournalCopy(from, written).run();
        }
        try (JournalReader copy = to.read()) {
            if (!copy.checksum().equals(from.checksum())) {
                throw new JournalException(
                        to.toString(),
                        0,
                        "is no equal copy: an earlier version of this program wrote the inputs in another form. Go on with the"
                                + " journal itself");
            }
            return copy.checksum();
        }
    }

    private void run() throws IOException {
        after(0);
        from.entries(1, from.lastIndex(), this::take);
        write();
        if (failure.isPresent()) {
            throw failure.get();
        }
        to.addTelemetry(from.telemetry().rows());
        to.sync();
    }

    private void take(JournalEntry entry) {
        batch.add(entry);
        boolean marked =
                marks.containsKey(entry.index()) || from.snapshot(entry.index()).isPresent();
        if (failure.isEmpty() && (marked || batch.size() >= BATCH)) {
            try {
                write();
                after(entry.index());
            } catch (IOException fault) {
                failure = Optional.of(fault);
            }
        }
    }

    private void write() throws IOException {
        if (!batch.isEmpty() && failure.isEmpty()) {
            to.append(batch, Durability.PROCESS);
        }
        batch.clear();
    }

    /** What is bound to an entry; a snapshot is taken along where one is due. */
    private void after(long index) throws IOException {
        if (marks.containsKey(index)) {
            to.mark(marks.get(index));
        }
        Optional<byte[]> state = from.snapshot(index);
        if (state.isPresent()) {
            to.offerSnapshot(state::get);
        }
    }
}
