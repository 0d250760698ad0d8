package org.sami.spn.replay;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalPlans;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Effect;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The engine's part of a session's journal, run again to any of its entries, forwards and back. Read at once and never written; of a journal that
 * is damaged on its way this is what stands before the damage. For one thread at a time.
 */
public final class JournalRun {
    private static final int COPY_EVERY = 200;

    private final Path file;
    private final Engine engine;
    private final List<JournalEntry> entries;
    private final TimeLine timeLine;
    private final Optional<String> damage;
    private final NavigableMap<Integer, EngineState> copies = new TreeMap<>();
    private EngineState state;
    private List<Effect> effects = List.of();
    private int taken;

    private JournalRun(Path file, JournalReader reader) throws IOException {
        this.file = file;
        JournalAddress journal = JournalAddress.of(file);
        Vocabulary vocabulary = JournalPlans.vocabulary(journal, reader.header());
        engine = new Engine(vocabulary, JournalPlans.project(journal, reader.header(), vocabulary));
        entries = List.copyOf(reader.entries());
        damage = reader.recovery().damage();
        TimeLineBuilder line = new TimeLineBuilder();
        state = engine.newState();
        copies.put(0, state.copy());
        for (JournalEntry entry : entries) {
            line.entry(entry, engine.step(state, entry.atMillis(), entry.input()));
            taken++;
            if (taken % COPY_EVERY == 0) {
                copies.put(taken, state.copy());
            }
        }
        timeLine = line.build();
        goToEntry(0);
    }

    /**
     * Reads a journal.
     *
     * @throws IOException with one sentence that names the file, if there is none, it is no journal, it is damaged from its head, or this
     *     program cannot read its plans
     */
    public static JournalRun open(Path file) throws IOException {
        if (!Files.isRegularFile(file)) {
            throw new NoSuchFileException("there is no journal " + file);
        }
        try (JournalReader reader = JournalReader.open(file)) {
            return new JournalRun(file, reader);
        }
    }

    /** The file that was read. */
    public Path file() {
        return file;
    }

    /** The project with which the session began. */
    public Project project() {
        return engine.project();
    }

    /** The words of the session. */
    public Vocabulary vocabulary() {
        return engine.vocabulary();
    }

    /** When what happened. */
    public TimeLine timeLine() {
        return timeLine;
    }

    /** What of the file could not be read, in a sentence; empty where all could. */
    public Optional<String> damage() {
        return damage;
    }

    /** How many entries it has. */
    public int entries() {
        return entries.size();
    }

    /** How many entries have been run to get here. */
    public int taken() {
        return taken;
    }

    /** What the last entry that was run did; empty at the start. */
    public List<Effect> effects() {
        return effects;
    }

    /** How many entries there are until a moment, those of that moment included. */
    public int entriesUntil(long millis) {
        int count = 0;
        while (count < entries.size() && entries.get(count).atMillis() <= millis) {
            count++;
        }
        return count;
    }

    /** When an entry happened, in ms of the session's clock; 0 for the start. */
    public long atMillis(int entry) {
        return entry == 0 ? 0 : entries.get(entry - 1).atMillis();
    }

    /** Stands behind the entries that happened until a moment. */
    public void goTo(long millis) {
        goToEntry(entriesUntil(millis));
    }

    /**
     * Stands behind an entry, counted from 1; 0 is the start.
     *
     * @throws IllegalArgumentException if there is no such entry
     */
    public void goToEntry(int entry) {
        if (entry < 0 || entry > entries.size()) {
            throw new IllegalArgumentException("entries go to " + entries.size() + ", not to " + entry);
        }
        if (entry < taken) {
            Map.Entry<Integer, EngineState> copy = copies.floorEntry(Math.max(0, entry - 1));
            state = copy.getValue().copy();
            taken = copy.getKey();
            effects = List.of();
        }
        while (taken < entry) {
            JournalEntry next = entries.get(taken++);
            List<Effect> did = new ArrayList<>();
            engine.step(state, next.atMillis(), next.input(), did::add);
            effects = List.copyOf(did);
        }
    }

    /** Questions about what stands where now; valid until another moment is gone to. */
    public EngineView view() {
        return engine.view(state);
    }
}
