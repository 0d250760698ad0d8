package org.sami.crw.session.archive;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.InputJournal;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.NoJournal;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.journal.SqliteJournal;
import org.sami.spn.journal.Telemetry;
import org.sami.spn.journal.TelemetryRow;

/**
 * The journal of a session: the engine's inputs, telemetry next to them, and what earlier processes of the session left. It
 * survives the loss of power: real boats go on without the laptop. Telemetry may be added from any thread.
 */
public final class SessionJournal implements Closeable {
    private final Optional<SqliteJournal> file;
    private final InputJournal inputs;
    private final boolean resumed;
    private final long cameToMillis;
    private final Optional<String> telemetryDamage;

    private SessionJournal(SqliteJournal journal) {
        file = Optional.of(journal);
        inputs = journal;
        resumed = false;
        cameToMillis = 0;
        telemetryDamage = Optional.empty();
    }

    private SessionJournal(SqliteJournal journal, Telemetry earlier) {
        file = Optional.of(journal);
        inputs = journal;
        resumed = true;
        cameToMillis = earlier.rows().stream().mapToLong(TelemetryRow::atMillis).reduce(inputs.lastMillis(), Math::max);
        telemetryDamage = earlier.damage();
    }

    private SessionJournal(InputJournal inputs) {
        file = Optional.empty();
        this.inputs = inputs;
        resumed = false;
        cameToMillis = 0;
        telemetryDamage = Optional.empty();
    }

    /** A journal that nobody reads again. */
    public static SessionJournal none() {
        return over(new NoJournal());
    }

    /** A journal of inputs that another owner keeps, for a session that begins; telemetry is not kept. */
    public static SessionJournal over(InputJournal inputs) {
        return new SessionJournal(inputs);
    }

    /**
     * The journal of a session that begins.
     *
     * @throws IOException if there is one already, or none can be made
     */
    public static SessionJournal create(Path file, JournalHeader header) throws IOException {
        return new SessionJournal(SqliteJournal.create(file, header, JournalOptions.DEFAULT));
    }

    /**
     * The journal of a session that is resumed.
     *
     * @throws IOException if it is no journal, is damaged from its head, or another process writes it
     */
    public static SessionJournal open(Path file) throws IOException {
        SqliteJournal journal = SqliteJournal.open(file, JournalOptions.DEFAULT);
        try (JournalReader reader = JournalReader.open(file)) {
            return new SessionJournal(journal, reader.telemetry());
        } catch (IOException | RuntimeException fault) {
            journal.close();
            throw fault;
        }
    }

    /** What the file says before its first entry; empty where there is no file. */
    public Optional<JournalHeader> header() {
        return file.map(SqliteJournal::header);
    }

    /** What was wrong with the file, in a sentence; empty text where nothing was. */
    public String damage() {
        return Stream.concat(file.flatMap(journal -> journal.recovery().damage()).stream(), telemetryDamage.stream())
                .collect(Collectors.joining("; "));
    }

    /** Index of the last entry that an earlier process wrote; empty for a session from its start. */
    public OptionalLong resumedFrom() {
        return resumed ? OptionalLong.of(file.orElseThrow().recovery().lastValid()) : OptionalLong.empty();
    }

    /** How many entries this process has added. */
    public long added() {
        return inputs.lastIndex() - resumedFrom().orElse(0);
    }

    /** The session's time to which earlier processes came, in milliseconds, as far as the journal knows. */
    public long cameToMillis() {
        return resumed ? cameToMillis : inputs.lastMillis();
    }

    /** The telemetry of earlier processes, in order, as far as it is undamaged. */
    public List<TelemetryRow> earlier() throws IOException {
        if (!resumed) {
            return List.of();
        }
        try (JournalReader reader = JournalReader.open(file.orElseThrow().file())) {
            return reader.telemetry().rows();
        }
    }

    /** Gives the entries of earlier processes, in order. */
    public void earlierEntries(Consumer<JournalEntry> consumer) throws IOException {
        if (resumed && resumedFrom().getAsLong() > 0) {
            try (JournalReader reader = JournalReader.open(file.orElseThrow().file())) {
                reader.entries(1, resumedFrom().getAsLong(), consumer);
            }
        }
    }

    /** The file of the journal; empty where nobody reads it again. */
    public Optional<SqliteJournal> sqlite() {
        return file;
    }

    /** The journal of the engine's inputs. */
    public InputJournal inputs() {
        return inputs;
    }

    /** The state to go on from. */
    public EngineState restore(Engine engine) throws IOException {
        return resumed ? file.orElseThrow().restore(engine) : engine.newState();
    }

    /** Lets a listener hear what happened in earlier processes. */
    public void replay(Engine engine, HostListener listener) throws IOException {
        if (resumed && resumedFrom().getAsLong() > 0) {
            try (JournalReader reader = JournalReader.open(file.orElseThrow().file())) {
                reader.replay(engine, 1, resumedFrom().getAsLong(), listener);
            }
        }
    }

    /** Whether added telemetry is kept; otherwise none need be made. */
    public boolean keepsTelemetry() {
        return file.isPresent();
    }

    void addTelemetry(TelemetryRow row) throws IOException {
        if (file.isPresent()) {
            file.get().addTelemetry(List.of(row));
        }
    }

    @Override
    public void close() throws IOException {
        if (file.isPresent()) {
            file.get().close();
        }
    }
}
