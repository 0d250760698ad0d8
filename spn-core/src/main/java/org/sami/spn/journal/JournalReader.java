package org.sami.spn.journal;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.JournalException;

/**
 * Reads a journal, also one that is being written: what was durable when it was opened. Used by one thread at a time.
 */
public final class JournalReader implements AutoCloseable {
    private final Database database;
    private final Contents contents;
    private final History history;

    private JournalReader(Database database, Contents contents) {
        this.database = database;
        this.contents = contents;
        this.history = new History(database.file(), database.connection(), contents);
    }

    /**
     * Reads it once and finds out how far it is true.
     *
     * @throws JournalException where not even the header is
     */
    public static JournalReader open(Path file) throws JournalException {
        JournalLock.checkName(file);
        Database database = Database.open(file);
        try {
            return new JournalReader(database, Scan.of(file, database.connection()));
        } catch (JournalException refused) {
            database.close();
            throw refused;
        }
    }

    /** What the journal says before its first entry. */
    public JournalHeader header() {
        return contents.header();
    }

    /** How far it is true. */
    public Recovery recovery() {
        return new Recovery(contents.lastValid(), contents.damage());
    }

    /** Index of the last valid entry; 0 where there is none. */
    public long lastIndex() {
        return contents.lastValid();
    }

    /** The session's time of the last valid entry; 0 where there is none. */
    public long lastMillis() {
        return contents.lastMillis();
    }

    /** All valid entries, in order. */
    public List<JournalEntry> entries() throws JournalException {
        List<JournalEntry> all = new ArrayList<>();
        entries(1, lastIndex(), all::add);
        return all;
    }

    /** Valid entries from one to another, both included, in order, without holding them all. */
    public void entries(long first, long last, Consumer<JournalEntry> consumer) throws JournalException {
        history.entries(first - 1, Math.min(last, lastIndex()), consumer);
    }

    /**
     * The state after an entry, by the snapshot before it and replay; 0 is the state before the first.
     *
     * @param engine built from this journal's plans and vocabulary ({@link #header()})
     * @throws IllegalArgumentException if the index is not that of a valid entry
     */
    public EngineState stateAt(long index, Engine engine) throws JournalException {
        return history.stateAt(index, engine);
    }

    /**
     * Lets a listener hear entries again, from one to another, both included. Same plans and same journal give the same
     * effects as in the session (R-DET-1).
     */
    public void replay(Engine engine, long first, long last, HostListener listener) throws JournalException {
        history.replay(engine, first, last, listener);
    }

    /**
     * The marks of the simulated world, in order.
     *
     * @throws JournalException where one of them does not hold
     */
    public List<WorldMark> marks() throws JournalException {
        return history.marks();
    }

    /** The telemetry, in the order in which it was added, without what is damaged. Read again at each call. */
    public Telemetry telemetry() {
        return new TelemetryScan(database).run();
    }

    @Override
    public void close() throws JournalException {
        database.close();
    }
}
