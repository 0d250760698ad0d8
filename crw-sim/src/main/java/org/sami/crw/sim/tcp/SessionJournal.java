package org.sami.crw.sim.tcp;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.crw.sim.resume.EarlierProcesses;
import org.sami.crw.sim.resume.RunRecord;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.InputJournal;
import org.sami.spn.host.MemoryJournal;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.journal.SqliteJournal;
import org.sami.spn.journal.TelemetryRow;

/**
 * The journal of a run behind TCP: the engine's inputs, telemetry beside them, and what earlier processes of the run left. It
 * survives the loss of power: real boats go on without the laptop.
 */
public final class SessionJournal implements EarlierProcesses, AutoCloseable {
    private final Optional<SqliteJournal> file;
    private final InputJournal inputs;
    private final List<TelemetryRow> earlier;
    private final boolean resumed;

    private SessionJournal(SqliteJournal journal, List<TelemetryRow> earlier, boolean resumed) {
        file = Optional.of(journal);
        inputs = journal;
        this.earlier = earlier;
        this.resumed = resumed;
    }

    private SessionJournal() {
        file = Optional.empty();
        inputs = new MemoryJournal();
        earlier = List.of();
        resumed = false;
    }

    /** A journal that nobody reads again. */
    public static SessionJournal none() {
        return new SessionJournal();
    }

    /**
     * The journal of a run that begins.
     *
     * @throws IOException if there is one already, or none can be made
     */
    public static SessionJournal create(Path file, RunRecord record) throws IOException {
        return new SessionJournal(
                SqliteJournal.create(file, record.toHeader(), JournalOptions.DEFAULT), List.of(), false);
    }

    /**
     * The journal of a run that is taken up.
     *
     * @throws IOException if it is no journal, is damaged from its head, or another process writes it
     */
    public static SessionJournal open(Path file) throws IOException {
        SqliteJournal journal = SqliteJournal.open(file, JournalOptions.DEFAULT);
        try (JournalReader reader = JournalReader.open(file)) {
            return new SessionJournal(journal, reader.telemetry(), true);
        } catch (IOException | RuntimeException fault) {
            journal.close();
            throw fault;
        }
    }

    @Override
    public RunRecord record() {
        return RunRecord.of(file.orElseThrow().header());
    }

    @Override
    public List<String> differences(String project, Map<String, String> vocabulary) {
        return file.orElseThrow().header().differences(record().source(), project, vocabulary);
    }

    @Override
    public String damage() {
        return file.flatMap(journal -> journal.recovery().damage()).orElse("");
    }

    @Override
    public OptionalLong resumedFrom() {
        return resumed ? OptionalLong.of(file.orElseThrow().recovery().lastValid()) : OptionalLong.empty();
    }

    /** How many entries this process has added. */
    public long added() {
        return inputs.lastIndex() - resumedFrom().orElse(0);
    }

    @Override
    public long cameToMillis() {
        return earlier.stream().mapToLong(TelemetryRow::atMillis).reduce(inputs.lastMillis(), Math::max);
    }

    /** What earlier processes wrote beside the inputs, in order. */
    List<TelemetryRow> earlier() {
        return earlier;
    }

    InputJournal inputs() {
        return inputs;
    }

    /** The state to go on from. */
    EngineState restore(Engine engine) throws IOException {
        return resumed ? file.orElseThrow().restore(engine) : engine.newState();
    }

    /** Lets a listener hear what happened in earlier processes. */
    void replay(Engine engine, HostListener listener) throws IOException {
        if (resumed && resumedFrom().getAsLong() > 0) {
            try (JournalReader reader = JournalReader.open(file.orElseThrow().file())) {
                reader.replay(engine, 1, resumedFrom().getAsLong(), listener);
            }
        }
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
