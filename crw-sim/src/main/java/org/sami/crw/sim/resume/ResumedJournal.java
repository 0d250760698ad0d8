package org.sami.crw.sim.resume;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.sami.crw.sim.run.RunJournal;
import org.sami.spn.host.Durability;
import org.sami.spn.host.InputJournal;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.journal.StoredJournal;
import org.sami.spn.journal.WorldMark;

/**
 * The journal of a run that is taken up: as far as it goes, what the run produces is compared with it, and from then on
 * written to it. The run does not notice.
 */
public final class ResumedJournal implements RunJournal, EarlierProcesses, AutoCloseable {
    private static final int WORDS_LENGTH = 160;

    private final StoredJournal journal;
    private final PastEntries past;
    private final Map<Long, MarkText> marks;
    private final Inputs inputs = new Inputs();
    private final long knownUntilMillis;
    private long index;
    private long reachedMillis = -1;

    private ResumedJournal(StoredJournal journal, PastEntries past, Map<Long, MarkText> marks) {
        this.journal = journal;
        this.past = past;
        this.marks = marks;
        MarkText last = marks.get(past.size());
        knownUntilMillis = last == null ? -1 : last.atMillis();
    }

    /**
     * Opens a journal to go on with it.
     *
     * @throws IOException if it is no journal, is damaged from its head, or another process writes it
     */
    public static ResumedJournal open(Path file) throws IOException {
        return open(JournalAddress.of(file));
    }

    /**
     * Opens a journal to go on with it.
     *
     * @throws IOException if it is no journal, is damaged from its head, or another process writes it
     */
    public static ResumedJournal open(JournalAddress address) throws IOException {
        StoredJournal journal = address.open(WrittenJournal.OPTIONS);
        JournalReader reader = null;
        try {
            Optional<String> other = RunRecord.otherDriving(journal.header());
            if (other.isPresent()) {
                throw new IOException(address + ": " + other.get());
            }
            reader = journal.reader();
            Map<Long, MarkText> marks = new TreeMap<>();
            for (WorldMark mark : reader.marks()) {
                marks.put(mark.index(), MarkText.of(mark));
            }
            return new ResumedJournal(journal, new PastEntries(reader), marks);
        } catch (IOException | RuntimeException fault) {
            if (reader != null) {
                reader.close();
            }
            journal.close();
            throw fault;
        }
    }

    @Override
    public RunRecord record() {
        return RunRecord.of(journal.header());
    }

    @Override
    public List<String> differences(String project, Map<String, String> vocabulary) {
        return journal.header().differences(record().source(), project, vocabulary);
    }

    @Override
    public String damage() {
        return journal.recovery().damage().orElse("");
    }

    @Override
    public long cameToMillis() {
        return marks.values().stream().mapToLong(MarkText::atMillis).reduce(past.lastMillis(), Math::max);
    }

    /** How many entries the run has added since. */
    public long added() {
        return Math.max(0, index - past.size());
    }

    @Override
    public InputJournal inputs() {
        return inputs;
    }

    @Override
    public void mark(long atMillis, Supplier<String> fingerprint) throws IOException {
        reachedMillis = atMillis;
        MarkText known = marks.get(index);
        if (known != null && known.contradicts(atMillis, fingerprint.get())) {
            throw new JournalMismatchException(
                    index, "the boats are elsewhere " + atMillis / 1000.0 + " s after the start than they were");
        }
        if (isNews(atMillis)) {
            journal.mark(new MarkText(atMillis, fingerprint.get()).toString());
        }
    }

    private boolean isNews(long atMillis) {
        return index > past.size() || (index == past.size() && atMillis > knownUntilMillis);
    }

    @Override
    public void stopped(long atMillis) throws IOException {
        if (isNews(atMillis)) {
            journal.mark(MarkText.stopped(atMillis).toString());
        }
    }

    @Override
    public boolean isCatchingUp() {
        return index < past.size() || (index == past.size() && reachedMillis < knownUntilMillis);
    }

    @Override
    public OptionalLong resumedFrom() {
        return OptionalLong.of(past.size());
    }

    @Override
    public void over() throws IOException {
        if (index < past.size()) {
            throw new JournalMismatchException(
                    index + 1,
                    "this program ends the mission before it; the journal has "
                            + past.get(index + 1).input().getClass().getSimpleName());
        }
    }

    @Override
    public void close() throws IOException {
        try (StoredJournal written = journal;
                PastEntries read = past) {
            // Both are closed, the reader first.
        }
    }

    private final class Inputs implements InputJournal {
        private long lastMillis;

        @Override
        public long lastIndex() {
            return index;
        }

        @Override
        public long lastMillis() {
            return lastMillis;
        }

        @Override
        public void append(List<JournalEntry> batch, Durability durability) throws IOException {
            int known = (int) Math.min(batch.size(), Math.max(0, past.size() - index));
            for (JournalEntry entry : batch.subList(0, known)) {
                compare(past.get(entry.index()), entry);
            }
            if (known < batch.size()) {
                journal.append(batch.subList(known, batch.size()), durability);
            }
            index += batch.size();
            lastMillis =
                    batch.isEmpty() ? lastMillis : batch.get(batch.size() - 1).atMillis();
        }

        private void compare(JournalEntry expected, JournalEntry entry) throws JournalMismatchException {
            if (!expected.equals(entry)) {
                throw new JournalMismatchException(
                        entry.index(), "it holds " + words(expected) + ", but this program comes to " + words(entry));
            }
        }

        private static String words(JournalEntry entry) {
            return shortened(entry.input().toString()) + " at " + entry.atMillis() / 1000.0 + " s";
        }

        private static String shortened(String text) {
            return text.length() <= WORDS_LENGTH ? text : text.substring(0, WORDS_LENGTH) + "...";
        }

        @Override
        public void offerSnapshot(Supplier<byte[]> state) throws IOException {
            if (index > past.size()) {
                journal.offerSnapshot(state);
            }
        }

        @Override
        public void sync() throws IOException {
            journal.sync();
        }

        @Override
        public void close() {
            // The outer object closes the file.
        }
    }
}
