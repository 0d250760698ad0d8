package org.sami.crw.session.archive;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.InputJournal;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.NoJournal;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.JournalPart;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.journal.StoredJournal;
import org.sami.spn.journal.Telemetry;
import org.sami.spn.journal.TelemetryRow;

/**
 * The journal of a session: the engine's inputs, telemetry next to them, and what earlier processes of the session left. It
 * survives the loss of power: real boats go on without the laptop. Telemetry may be added from any thread.
 */
public final class SessionJournal implements Closeable {
    private final Optional<StoredJournal> stored;
    private final Optional<JournalHeader> header;
    private final InputJournal inputs;
    private final boolean resumed;
    private final long cameToMillis;
    private final Optional<String> telemetryDamage;
    private volatile Optional<List<TelemetryRow>> earlier = Optional.empty(); // until the session begins

    private SessionJournal(StoredJournal journal) {
        stored = Optional.of(journal);
        header = Optional.of(journal.header());
        inputs = journal;
        resumed = false;
        cameToMillis = 0;
        telemetryDamage = Optional.empty();
    }

    private SessionJournal(StoredJournal journal, Telemetry earlier) {
        stored = Optional.of(journal);
        header = Optional.of(journal.header());
        inputs = journal;
        resumed = true;
        cameToMillis = earlier.rows().stream().mapToLong(TelemetryRow::atMillis).reduce(inputs.lastMillis(), Math::max);
        telemetryDamage = earlier.damage();
        this.earlier = Optional.of(List.copyOf(earlier.rows()));
    }

    private SessionJournal(InputJournal inputs, Optional<JournalHeader> header) {
        stored = Optional.empty();
        this.header = header;
        this.inputs = inputs;
        resumed = false;
        cameToMillis = 0;
        telemetryDamage = Optional.empty();
    }

    /** Whether another base writes it now, so that this one commands nothing any more. From any thread. */
    public boolean isTakenOver() {
        return stored.map(StoredJournal::isTakenOver).orElse(false);
    }

    /** A journal that nobody reads again. */
    public static SessionJournal none() {
        return over(new NoJournal());
    }

    /**
     * A journal that nobody reads again.
     *
     * @param header what it would say before its first entry, for fronts in other processes
     */
    public static SessionJournal none(JournalHeader header) {
        return new SessionJournal(new NoJournal(), Optional.of(header));
    }

    /** A journal of inputs that another owner keeps, for a session that begins; telemetry is not kept. */
    public static SessionJournal over(InputJournal inputs) {
        return new SessionJournal(inputs, Optional.empty());
    }

    /**
     * The journal of a session that begins.
     *
     * @throws IOException if there is one already, or none can be made
     */
    public static SessionJournal create(Path file, JournalHeader header) throws IOException {
        return create(JournalAddress.of(file), header);
    }

    /**
     * The journal of a session that begins.
     *
     * @throws IOException if there is one already, or none can be made
     */
    public static SessionJournal create(JournalAddress address, JournalHeader header) throws IOException {
        return new SessionJournal(address.create(header, JournalOptions.DEFAULT));
    }

    /**
     * The journal of a session that is resumed.
     *
     * @throws IOException if it is no journal, is damaged from its head, or another process writes it
     */
    public static SessionJournal open(Path file) throws IOException {
        return open(JournalAddress.of(file));
    }

    /**
     * The journal of a session that is resumed.
     *
     * @throws IOException if it is no journal, is damaged from its head, or another process writes it
     */
    public static SessionJournal open(JournalAddress address) throws IOException {
        return resumed(address.open(JournalOptions.DEFAULT));
    }

    /**
     * The journal of a session that another base holds, once that base's lease is over; waits until then.
     *
     * @param address in a database that both bases reach
     * @param lines what is waited for, for people
     * @param ahead what of the journal was read meanwhile; asked once, when nobody else can write any more
     * @throws java.io.InterruptedIOException if the thread is interrupted
     * @throws IOException if the database refuses the first connection, or the journal cannot be opened
     */
    public static SessionJournal takeOver(
            JournalAddress address, Consumer<String> lines, Supplier<Optional<JournalPart>> ahead) throws IOException {
        return resumed(address.takeOver(JournalOptions.DEFAULT, lines, ahead));
    }

    private static SessionJournal resumed(StoredJournal journal) throws IOException {
        try (JournalReader reader = journal.reader()) {
            return new SessionJournal(journal, reader.telemetry());
        } catch (IOException | RuntimeException fault) {
            journal.close();
            throw fault;
        }
    }

    /** What the journal says before its first entry; empty where nobody reads it. */
    public Optional<JournalHeader> header() {
        return header;
    }

    /** What was wrong with the journal, in a sentence; empty text where nothing was. */
    public String damage() {
        return Stream.concat(stored.flatMap(journal -> journal.recovery().damage()).stream(), telemetryDamage.stream())
                .collect(Collectors.joining("; "));
    }

    /** Index of the last entry that an earlier process wrote; empty for a session from its start. */
    public OptionalLong resumedFrom() {
        return resumed ? OptionalLong.of(stored.orElseThrow().recovery().lastValid()) : OptionalLong.empty();
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
        Optional<List<TelemetryRow>> read = earlier;
        if (!resumed || read.isPresent()) {
            return read.orElse(List.of());
        }
        try (JournalReader reader = stored.orElseThrow().reader()) {
            return reader.telemetry().rows();
        }
    }

    /**
     * The projects that earlier processes loaded, by the SHA-256 of their documents.
     *
     * @throws IOException if the journal cannot be read
     */
    public Map<String, String> earlierDocuments() throws IOException {
        if (!resumed) {
            return Map.of();
        }
        try (JournalReader reader = stored.orElseThrow().reader()) {
            return reader.documents();
        }
    }

    /** The session goes on: what was kept in memory for its beginning is let go. */
    public void begun() {
        earlier = Optional.empty();
        stored.ifPresent(StoredJournal::begun);
    }

    /** Gives the entries of earlier processes, in order. */
    public void earlierEntries(Consumer<JournalEntry> consumer) throws IOException {
        if (resumed && resumedFrom().getAsLong() > 0) {
            try (JournalReader reader = stored.orElseThrow().reader()) {
                reader.entries(1, resumedFrom().getAsLong(), consumer);
            }
        }
    }

    /** The journal, where somebody reads it again. */
    public Optional<StoredJournal> stored() {
        return stored;
    }

    /** How many bases have held it up to this one; 0 where it is in no database. */
    public long epoch() {
        return stored.map(StoredJournal::epoch).orElse(0L);
    }

    /** Its file; empty where it is in a database, or nobody reads it again. */
    public Optional<Path> file() {
        return stored.flatMap(StoredJournal::inFile);
    }

    /** The journal of the engine's inputs. */
    public InputJournal inputs() {
        return inputs;
    }

    /** The state to go on from. */
    public EngineState restore(Engine engine) throws IOException {
        return resumed ? stored.orElseThrow().restore(engine) : engine.newState();
    }

    /** Lets a listener hear what happened in earlier processes. */
    public void replay(Engine engine, HostListener listener) throws IOException {
        if (resumed && resumedFrom().getAsLong() > 0) {
            try (JournalReader reader = stored.orElseThrow().reader()) {
                reader.replay(engine, 1, resumedFrom().getAsLong(), listener);
            }
        }
    }

    /** Whether added telemetry is kept, or may be followed by fronts elsewhere; otherwise none need be made. */
    public boolean keepsTelemetry() {
        return header.isPresent();
    }

    /**
     * Adds a row of telemetry, where this keeps any.
     *
     * @throws IOException if it cannot be written
     */
    public void addTelemetry(TelemetryRow row) throws IOException {
        if (stored.isPresent()) {
            stored.get().addTelemetry(List.of(row));
        }
    }

    @Override
    public void close() throws IOException {
        if (stored.isPresent()) {
            stored.get().close();
        }
    }
}
