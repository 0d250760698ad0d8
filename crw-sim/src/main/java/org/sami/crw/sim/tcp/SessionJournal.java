package org.sami.crw.sim.tcp;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.crw.sim.resume.EarlierProcesses;
import org.sami.crw.sim.resume.RunRecord;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.InputJournal;
import org.sami.spn.host.NoJournal;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.journal.SqliteJournal;
import org.sami.spn.journal.Telemetry;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.protocol.Input;

/**
 * The journal of a run behind TCP: the engine's inputs, telemetry beside them, and what earlier processes of the run left. It
 * survives the loss of power: real boats go on without the laptop.
 */
public final class SessionJournal implements EarlierProcesses, AutoCloseable {
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

    private SessionJournal() {
        file = Optional.empty();
        inputs = new NoJournal();
        resumed = false;
        cameToMillis = 0;
        telemetryDamage = Optional.empty();
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
        return new SessionJournal(SqliteJournal.create(file, record.toHeader(), JournalOptions.DEFAULT));
    }

    /**
     * The journal of a run that is taken up.
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
        return Stream.concat(file.flatMap(journal -> journal.recovery().damage()).stream(), telemetryDamage.stream())
                .collect(Collectors.joining("; "));
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
        return resumed ? cameToMillis : inputs.lastMillis();
    }

    /** What earlier processes wrote beside the inputs, in order, as far as it is not damaged. */
    List<TelemetryRow> earlier() throws IOException {
        if (!resumed) {
            return List.of();
        }
        try (JournalReader reader = JournalReader.open(file.orElseThrow().file())) {
            return reader.telemetry().rows();
        }
    }

    /** The boats with which an earlier process started the mission, in order; empty if none did. */
    Optional<List<String>> startedWith() throws IOException {
        List<String> joined = new ArrayList<>();
        boolean[] started = new boolean[1];
        if (resumed) {
            try (JournalReader reader = JournalReader.open(file.orElseThrow().file())) {
                reader.entries(1, resumedFrom().getAsLong(), entry -> {
                    if (entry.input() instanceof Input.ProxyJoined proxy && !started[0]) {
                        joined.add(proxy.proxy());
                    }
                    started[0] |= entry.input() instanceof Input.StartMission;
                });
            }
        }
        return started[0] ? Optional.of(joined) : Optional.empty();
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
