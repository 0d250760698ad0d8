package org.sami.spn.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.spn.host.HostPlans.number;
import static org.sami.spn.host.HostPlans.numberOf;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.EngineHostBuilder;
import org.sami.spn.host.HostPlans;
import org.sami.spn.host.HostStatus;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.host.MonotonicHostClock;

/** A host with its journal on disk, under real threads. */
@Timeout(900)
class HostedJournalTest {
    private static final int THREADS = 8;
    private static final int EACH = 2000;
    private static final long THREAD_STEP = 1_000_000;

    @TempDir
    Path folder;

    private final ExecutorService engineThread = Executors.newSingleThreadExecutor();
    private final MonotonicHostClock clock = new MonotonicHostClock(0);
    private final Engine engine = HostPlans.engine();
    private final EngineState state = engine.newState();

    @AfterEach
    void endThreads() {
        clock.close();
        engineThread.shutdownNow();
    }

    private EngineHost host(SqliteJournal journal) {
        return EngineHostBuilder.of(engine, state)
                .journal(journal)
                .clock(clock)
                .executor(engineThread)
                .build();
    }

    @Test
    void whatManyThreadsPostIsAllInTheFileInTheOrderOfEach() throws Exception {
        Path file = folder.resolve("session.journal");
        JournalOptions options = JournalOptions.DEFAULT.withSnapshotEvery(900);
        try (SqliteJournal journal = SqliteJournal.create(file, Tour.HEADER, options)) {
            EngineHost host = host(journal);
            List<Thread> posters = new ArrayList<>();
            for (int t = 0; t < THREADS; t++) {
                long base = t * THREAD_STEP;
                posters.add(new Thread(() -> {
                    for (int i = 0; i < EACH; i++) {
                        host.post(number(base + i));
                    }
                }));
            }
            posters.forEach(Thread::start);
            for (Thread poster : posters) {
                poster.join();
            }
            host.close();
            assertThat(host.status().kind()).isEqualTo(HostStatus.Kind.CLOSED);
        }

        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.lastIndex()).isEqualTo(THREADS * EACH);
            Map<Long, Long> next = new HashMap<>();
            for (JournalEntry entry : reader.entries()) {
                long number = numberOf(entry.input());
                assertThat(number % THREAD_STEP).isEqualTo(next.getOrDefault(number / THREAD_STEP, 0L));
                next.merge(number / THREAD_STEP, 1L, Long::sum);
            }
            assertThat(StateCodec.encode(reader.stateAt(reader.lastIndex(), engine)))
                    .isEqualTo(StateCodec.encode(state));
        }
    }

    @Test
    void aJournalThatCannotBeWrittenStopsTheHost() throws IOException {
        SqliteJournal journal =
                SqliteJournal.create(folder.resolve("session.journal"), Tour.HEADER, JournalOptions.DEFAULT);
        EngineHost host = host(journal);
        journal.close();
        List<Long> heard = new ArrayList<>();
        host.addListener((index, at, input, effects, view) -> heard.add(index));
        host.post(number(1));
        host.close();

        assertThat(host.status().kind()).isEqualTo(HostStatus.Kind.FAILED);
        assertThat(host.status().details()).contains("session.journal").contains("entry 1");
        assertThat(heard).isEmpty();
    }
}
