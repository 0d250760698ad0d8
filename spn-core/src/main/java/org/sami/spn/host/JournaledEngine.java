package org.sami.spn.host;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.vocabulary.EventFlag;

/**
 * An engine with its journal: what it is stepped through is durable before anybody hears what followed (decision 0030). Not safe for threads: for who
 * holds the host's lock.
 */
final class JournaledEngine {
    /** Entries that the journal gets at once while the engine takes the rest: so many go into one statement of a file. */
    private static final int PART = 128;

    private final EngineFunction engine;
    private final InputJournal journal;
    private final HostClock clock;
    private Batch undurable = Batch.NONE;

    /** What the engine was stepped through, with what followed. */
    private record Batch(List<Step> steps, List<JournalEntry> entries, Durability durability) {
        static final Batch NONE = new Batch(List.of(), List.of(), Durability.PROCESS);

        long lastIndex() {
            return entries.get(entries.size() - 1).index();
        }
    }

    JournaledEngine(EngineFunction engine, InputJournal journal, HostClock clock) {
        this.engine = engine;
        this.journal = journal;
        this.clock = clock;
    }

    /** Queries of the state, including inputs that are not durable yet. */
    EngineView view() {
        return engine.view();
    }

    /** Index of the last input that is durable; 0 where there is none. */
    long lastIndex() {
        return journal.lastIndex();
    }

    /**
     * Steps the engine through a batch at the session's time, which never goes back, and makes the batch durable. It survives the loss of power where
     * an output event of it is a command, else that of the process.
     *
     * @throws IOException if the journal fails: no effect of it may leave, and no other batch comes before {@link #recover} has returned this one
     */
    List<Step> step(List<QueuedInput> inputs) throws IOException {
        Batch batch = take(inputs);
        undurable = batch;
        journal.append(batch.entries(), batch.durability());
        undurable = Batch.NONE;
        return batch.steps();
    }

    /** Steps the engine; in a large batch the journal gets the entries part by part meanwhile. */
    private Batch take(List<QueuedInput> inputs) {
        List<Step> steps = new ArrayList<>(inputs.size());
        List<JournalEntry> entries = new ArrayList<>(inputs.size());
        Durability durability = Durability.PROCESS;
        long index = journal.lastIndex();
        long now = Math.max(clock.nowMillis(), journal.lastMillis());
        int prepared = 0;
        try {
            for (QueuedInput queued : inputs) {
                Input input = queued.input();
                index++;
                List<Effect> effects = new ArrayList<>(4);
                engine.step(now, input, effects::add);
                JournalEntry entry = new JournalEntry(index, now, input);
                entries.add(entry);
                Step step = Step.of(entry, effects, queued.reply());
                steps.add(step);
                if (durability == Durability.PROCESS && commands(step)) {
                    durability = Durability.POWER;
                }
                if (entries.size() == prepared + PART && entries.size() < inputs.size()) {
                    journal.prepare(List.copyOf(entries.subList(prepared, prepared + PART)));
                    prepared += PART;
                }
            }
        } catch (RuntimeException | Error fault) {
            journal.withdraw();
            throw fault;
        }
        return new Batch(steps, entries, durability);
    }

    /** Looks whether the journal has failed by itself. */
    void check() throws IOException {
        journal.check();
    }

    /** Whether {@link #recover} may help after the journal failed. */
    boolean isRecoverable() {
        return journal.isRecoverable();
    }

    /** How many inputs the engine was stepped through that are not durable. */
    int undurable() {
        return undurable.steps().size();
    }

    /**
     * Makes durable what the journal refused, if it refused a batch.
     *
     * @return what followed from that
     * @throws IOException if the journal fails still
     */
    List<Step> recover() throws IOException {
        journal.recover();
        Batch batch = undurable;
        if (!batch.steps().isEmpty()) {
            if (journal.lastIndex() < batch.lastIndex()) {
                journal.append(batch.entries(), batch.durability());
            } else if (batch.durability() == Durability.POWER) {
                journal.sync(); // it was written, and only not forced to the disk
            }
            undurable = Batch.NONE;
        }
        return batch.steps();
    }

    private boolean commands(Step step) {
        for (Activation activation : step.activations()) {
            if (isCommand(activation)) {
                return true;
            }
        }
        return false;
    }

    private boolean isCommand(Activation activation) {
        return engine.vocabulary()
                .event(activation.type())
                .filter(type -> type.flags().contains(EventFlag.COMMAND))
                .isPresent();
    }

    /** The state after the last step, as bytes. */
    byte[] encode() {
        return engine.encode();
    }

    /** Offers the journal the state after the last step. */
    void offerSnapshot() throws IOException {
        journal.offerSnapshot(engine::encode);
    }

    /** Makes all that was stepped survive the loss of power. */
    void sync() throws IOException {
        journal.sync();
    }
}
