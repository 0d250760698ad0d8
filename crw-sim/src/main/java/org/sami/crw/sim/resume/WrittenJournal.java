package org.sami.crw.sim.resume;

import java.io.IOException;
import java.nio.file.Path;
import java.util.OptionalLong;
import java.util.function.Supplier;
import org.sami.crw.sim.run.RunJournal;
import org.sami.spn.host.InputJournal;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.StoredJournal;

/** The journal of a run that begins. */
public final class WrittenJournal implements RunJournal, AutoCloseable {
    /** A simulated run survives its process; nobody loses a boat when a laptop loses its power in the middle of it. */
    static final JournalOptions OPTIONS = JournalOptions.DEFAULT.withoutSync();

    private final StoredJournal journal;

    private WrittenJournal(StoredJournal journal) {
        this.journal = journal;
    }

    /**
     * Makes a journal's file.
     *
     * @throws IOException if there is one already, or none can be made
     */
    public static WrittenJournal create(Path file, RunRecord record) throws IOException {
        return create(JournalAddress.of(file), record);
    }

    /**
     * Makes a journal.
     *
     * @throws IOException if there is one already, or none can be made
     */
    public static WrittenJournal create(JournalAddress address, RunRecord record) throws IOException {
        return new WrittenJournal(address.create(record.toHeader(), OPTIONS));
    }

    @Override
    public InputJournal inputs() {
        return journal;
    }

    @Override
    public void mark(long atMillis, Supplier<String> fingerprint) throws IOException {
        journal.mark(new MarkText(atMillis, fingerprint.get()).toString());
    }

    @Override
    public void stopped(long atMillis) throws IOException {
        journal.mark(MarkText.stopped(atMillis).toString());
    }

    @Override
    public boolean isCatchingUp() {
        return false;
    }

    @Override
    public OptionalLong resumedFrom() {
        return OptionalLong.empty();
    }

    @Override
    public void over() {
        // The last entry says it.
    }

    @Override
    public void close() throws IOException {
        journal.close();
    }
}
