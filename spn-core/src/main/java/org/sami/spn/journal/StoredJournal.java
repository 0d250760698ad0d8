package org.sami.spn.journal;

import java.io.IOException;
import java.util.List;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.host.InputJournal;

/**
 * A session's journal that is read again later, open for writing: in a file ({@link SqliteJournal}) or in a database ({@link JournalStore}). One writer at a time. Telemetry may be
 * added from any thread, everything else is called by the owner of the engine.
 */
public interface StoredJournal extends InputJournal {
    /** Where it is. */
    JournalAddress address();

    /** Its header. */
    JournalHeader header();

    /** What was found when it was opened. */
    Recovery recovery();

    /** Notes what a simulated world says of itself after the last entry; a second mark there replaces the first. */
    void mark(String text) throws IOException;

    /** Adds telemetry, from any thread; it is written soon, or with the next batch. */
    void addTelemetry(List<TelemetryRow> rows) throws IOException;

    /**
     * The state after the last entry that was there when the journal was opened: what a resume hosts.
     *
     * @param engine built from this journal's plans and vocabulary ({@link #header()})
     */
    EngineState restore(Engine engine) throws IOException;
}
