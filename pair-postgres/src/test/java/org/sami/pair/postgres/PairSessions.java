package org.sami.pair.postgres;

import java.io.IOException;
import java.time.Clock;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import org.sami.pair.postgres.Protection.State;
import org.sami.spn.host.Durability;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.StoredJournal;
import org.sami.spn.protocol.Input;

/** The sessions of a pair: the first base holds them, the second waits for them on a thread; notes what both are told. */
final class PairSessions implements AutoCloseable {
    private final TwoBases bases;
    private final BlockingQueue<State> states = new LinkedBlockingQueue<>();
    private final BlockingQueue<State> ofOther = new LinkedBlockingQueue<>();
    private final BlockingQueue<String> lines = new LinkedBlockingQueue<>();
    private final ExecutorService thread = Executors.newSingleThreadExecutor();

    PairSessions(TwoBases bases) {
        this.bases = bases;
    }

    /** Has the first base look after the standby of its session. */
    StandbyMonitor monitor() throws IOException {
        return BasePair.open(bases.first).monitor("sami", Clock.systemUTC(), (now, since) -> states.add(now.state()));
    }

    /** Has the first base look after the standby of another session. */
    StandbyMonitor monitorOfOther(String name) throws IOException {
        return BasePair.open(bases.first).monitor(name, Clock.systemUTC(), (now, since) -> ofOther.add(now.state()));
    }

    /** Waits until the first base's session is protected so. */
    void await(State state) throws InterruptedException {
        await(states, state);
    }

    /** Waits until the other session is protected so. */
    void awaitOfOther(State state) throws InterruptedException {
        await(ofOther, state);
    }

    /** What the other session was told since the last wait. */
    List<State> toldOther() {
        return List.copyOf(ofOther);
    }

    private static void await(BlockingQueue<State> states, State state) throws InterruptedException {
        State now = states.take();
        while (now != state) {
            now = states.take();
        }
    }

    /** Begins a session at the first base. */
    StoredJournal create(String name) throws IOException {
        return address(bases.first, name)
                .create(JournalHeader.of("plans", Map.of(), Map.of("kind", "session")), JournalOptions.DEFAULT);
    }

    /** Has the second base wait for a session; completes once it has taken it over. */
    Future<StoredJournal> takeOver(String name) {
        return thread.submit(
                () -> address(bases.second, name).takeOver(JournalOptions.DEFAULT, lines::add, Optional::empty));
    }

    /** Waits until the second base has said a line with these words while it waits for a session. */
    void awaitWords(String words) throws InterruptedException {
        String line = lines.take();
        while (!line.contains(words)) {
            line = lines.take();
        }
    }

    private static JournalAddress address(PairFolder folder, String name) throws IOException {
        return JournalAddress.parse(BasePair.open(folder).journal(name).text());
    }

    /** Appends an entry, which is on disk then. */
    static void write(StoredJournal journal, long index) throws IOException {
        journal.append(List.of(entry(index)), Durability.POWER);
    }

    static JournalEntry entry(long index) {
        return new JournalEntry(index, index * 1000, new Input.ProxyJoined("boat" + index));
    }

    @Override
    public void close() {
        thread.shutdownNow();
    }
}
