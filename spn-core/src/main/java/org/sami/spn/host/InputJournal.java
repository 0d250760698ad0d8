package org.sami.spn.host;

import java.io.IOException;
import java.util.List;
import java.util.function.Supplier;

/**
 * Where a host writes its inputs before their effects leave. Used by one thread at a time: whichever runs the engine.
 * After an exception the journal's end is unknown and nothing more may be written to it, before {@link #recover} has returned.
 */
public interface InputJournal extends AutoCloseable {
    /** Index of the last entry; 0 where there is none. */
    long lastIndex();

    /** The session's time of the last entry; 0 where there is none. */
    long lastMillis();

    /**
     * Appends entries as one batch, all or none. When it returns they survive what was asked for.
     *
     * @param entries in order, following {@link #lastIndex()} without a gap; beginning with those that were {@linkplain #prepare prepared}
     * @throws IOException where they could not be made durable; nothing that they caused may leave
     */
    void append(List<JournalEntry> entries, Durability durability) throws IOException;

    /**
     * Gives entries with which the next {@link #append} will begin, as soon as the engine has taken them: a journal may begin to write them while the engine
     * takes the rest of the batch. Returns at once. None of them is durable or can be read before that append has returned; what fails is told by it.
     *
     * @param entries in order, following those that were given before for the same batch, else {@link #lastIndex()}; not changed any more
     */
    default void prepare(List<JournalEntry> entries) {
        // They come once more, with the whole batch.
    }

    /** The batch whose first entries were given will not be appended. */
    default void withdraw() {
        // None of it was written.
    }

    /**
     * Offers the state after the last entry; the journal takes it when a snapshot is due.
     *
     * @param state encodes the state; called at most once, at once
     */
    void offerSnapshot(Supplier<byte[]> state) throws IOException;

    /** Makes all that was appended survive the loss of power. */
    void sync() throws IOException;

    /**
     * Checks whether the journal's own rows, in addition to the entries, could be written.
     *
     * @throws IOException if not: an append would fail as well
     */
    default void check() throws IOException {
        // Only entries are written.
    }

    /** Whether it can be written again after an exception, once {@link #recover} has returned. */
    default boolean isRecoverable() {
        return false;
    }

    /**
     * Looks whether it can be written again after an exception, such as one for a full disk. When it returns, {@link #lastIndex()} says what is in it: all
     * of the batch that failed or nothing of it.
     *
     * @throws IOException as long as it cannot
     */
    default void recover() throws IOException {
        throw new IOException("this journal is not gone on with after it failed");
    }

    @Override
    void close() throws IOException;
}
