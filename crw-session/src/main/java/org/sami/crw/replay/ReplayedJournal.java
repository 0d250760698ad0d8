package org.sami.crw.replay;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.spn.engine.Engine;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalPlans;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.journal.Telemetry;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.model.Project;
import org.sami.spn.replay.TimeLine;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What a session's journal holds, read at once and never written: also that of a session which runs, as far as it was durable when it was
 * read. Immutable.
 */
public final class ReplayedJournal {
    private final JournalAddress address;
    private final Vocabulary vocabulary;
    private final Project project;
    private final Engine engine;
    private final List<JournalEntry> entries;
    private final List<TelemetryRow> rows;
    private final TimeLine timeLine;
    private final Optional<String> damage;

    private ReplayedJournal(JournalAddress address, JournalReader reader) throws IOException {
        this.address = address;
        vocabulary = JournalPlans.vocabulary(address, reader.header());
        project = JournalPlans.project(address, reader.header(), vocabulary);
        engine = new Engine(vocabulary, project);
        entries = List.copyOf(reader.entries());
        Telemetry telemetry = reader.telemetry();
        List<TelemetryRow> ordered = new ArrayList<>(telemetry.rows());
        ordered.sort(Comparator.comparingLong(TelemetryRow::atMillis)); // those of one moment stay in order
        rows = List.copyOf(ordered);
        timeLine = SessionTimeLineBuilder.of(engine, entries, rows);
        List<String> wrong = Stream.concat(reader.recovery().damage().stream(), telemetry.damage().stream())
                .toList();
        damage = wrong.isEmpty() ? Optional.empty() : Optional.of(String.join("; ", wrong));
    }

    /**
     * Reads a journal in a file or a database. Of one that is damaged on its way this is what stands before the damage ({@link #damage}).
     *
     * @throws IOException with one sentence that names where it is, if there is none, it is no journal, it is damaged from its head, or this
     *     program cannot read its plans
     */
    public static ReplayedJournal open(JournalAddress address) throws IOException {
        if (!address.exists()) {
            throw new NoSuchFileException("there is no journal " + address);
        }
        try (JournalReader reader = address.read()) {
            return new ReplayedJournal(address, reader);
        }
    }

    /**
     * Reads a journal in a file.
     *
     * @throws IOException as {@link #open(JournalAddress)}
     */
    public static ReplayedJournal open(Path file) throws IOException {
        return open(JournalAddress.of(file));
    }

    /** Where it was read. */
    public JournalAddress address() {
        return address;
    }

    /** The words of the session. */
    public Vocabulary vocabulary() {
        return vocabulary;
    }

    /** The project with which the session began. */
    public Project project() {
        return project;
    }

    /** When what happened. */
    public TimeLine timeLine() {
        return timeLine;
    }

    /** What of it could not be read, in a sentence; empty where all could. */
    public Optional<String> damage() {
        return damage;
    }

    Engine engine() {
        return engine;
    }

    List<JournalEntry> entries() {
        return entries;
    }

    List<TelemetryRow> rows() {
        return rows;
    }
}
