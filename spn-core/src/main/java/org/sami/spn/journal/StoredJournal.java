package org.sami.spn.journal;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.host.InputJournal;
import org.sami.spn.host.JournalException;

/**
 * A session's journal that is read again later, open for writing: in a file or in a database. One writer at a time. Telemetry may be added from any thread,
 * everything else is called by the owner of the engine.
 */
public interface StoredJournal extends InputJournal {
    /** Its file; empty where it is in a database. */
    Optional<Path> inFile();

    /**
     * Reads what is written, also while more is written.
     *
     * @throws JournalException where not even the header is true
     */
    JournalReader reader() throws JournalException;

    /** Its header. */
    JournalHeader header();

    /** What was found when it was opened. */
    Recovery recovery();

    /** How many processes have held it up to this one, where a lease says who may write: a base with a lower number was superseded. 0 for a file, which has no lease. */
    default long epoch() {
        return 0;
    }

    /** Notes what a simulated world says of itself after the last entry; a second mark there replaces the first. */
    void mark(String text) throws IOException;

    /** Adds telemetry, from any thread; it is written soon, or with the next batch. */
    void addTelemetry(List<TelemetryRow> rows) throws IOException;

    /** Whether another process writes it now: whoever has this one commands nothing any more. From any thread. */
    default boolean isTakenOver() {
        return false;
    }

    /**
     * Why it may soon not be written, in plain words; empty while all is well, and where it cannot be written already. Waits for nobody. From any thread.
     */
    default Optional<String> warning() {
        return Optional.empty();
    }

    /**
     * The state after the last entry that was there when the journal was opened: what a resume hosts.
     *
     * @param engine built from this journal's plans and vocabulary ({@link #header()})
     */
    EngineState restore(Engine engine) throws IOException;

    /** The session goes on: what was kept in memory for its beginning is let go. */
    default void begun() {}
}
