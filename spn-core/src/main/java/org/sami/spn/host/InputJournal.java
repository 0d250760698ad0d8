package org.sami.spn.host;

import java.io.IOException;
import java.util.List;
import java.util.function.Supplier;

/**
 * Where a host writes its inputs before their effects leave. Used by one thread at a time: whichever runs the engine.
 * After an exception the journal's end is unknown and nothing more may be written to it.
 */
public interface InputJournal extends AutoCloseable {
    /** Index of the last entry; 0 where there is none. */
    long lastIndex();

    /** The session's time of the last entry; 0 where there is none. */
    long lastMillis();

    /**
     * Appends entries as one batch, all or none. When it returns they survive what was asked for.
     *
     * @param entries in order, following {@link #lastIndex()} without a gap
     * @throws IOException where they could not be made durable; nothing that they caused may leave
     */
    void append(List<JournalEntry> entries, Durability durability) throws IOException;

    /**
     * Offers the state after the last entry; the journal takes it when a snapshot is due.
     *
     * @param state encodes the state; called at most once, at once
     */
    void offerSnapshot(Supplier<byte[]> state) throws IOException;

    /** Makes all that was appended survive the loss of power. */
    void sync() throws IOException;

    @Override
    void close() throws IOException;
}
