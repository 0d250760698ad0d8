package org.sami.spn.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.spn.host.HostPlans.number;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HexFormat;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.LongStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.host.EngineFunction;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.EngineHostBuilder;
import org.sami.spn.host.HostPlans;
import org.sami.spn.host.HostStatus.Kind;
import org.sami.spn.host.MonotonicHostClock;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.testing.JavaProcess;
import org.sami.spn.vocabulary.Vocabulary;

/** Batches of a thousand inputs, which the file gets while the engine takes them. */
@Timeout(900)
class LargeBatchTest {
    private static final int SIZE = 1000;

    @TempDir
    Path folder;

    private final ExecutorService engineThread = Executors.newSingleThreadExecutor();
    private final MonotonicHostClock clock = new MonotonicHostClock(0);
    private final Engine engine = HostPlans.engine();
    private final EngineState state = engine.newState();
    private final CountDownLatch stepped = new CountDownLatch(SIZE);
    private Path file;

    @BeforeEach
    void chooseFile() {
        file = folder.resolve("session.journal");
    }

    @AfterEach
    void endThreads() {
        clock.close();
        engineThread.shutdownNow();
    }

    private EngineHost host(SqliteJournal journal, long faultAt) {
        return EngineHostBuilder.of(new Watched(faultAt))
                .journal(journal)
                .clock(clock)
                .executor(engineThread)
                .build();
    }

    private static List<Input> batch(long first) {
        List<Input> inputs = new ArrayList<>(Collections.nCopies(10, HostPlans.start("Tell")));
        LongStream.range(first, first + SIZE - inputs.size()).forEach(n -> inputs.add(number(n)));
        return inputs;
    }

    /** The same size, and ends the missions that run. */
    private static List<Input> ending(long first) {
        List<Input> inputs = new ArrayList<>(batch(first));
        inputs.set(SIZE / 2, new Input.AbortMission(Ids.NONE));
        return inputs;
    }

    @Test
    void theEngineDoesNotWaitForAFileThatIsSlowAndNothingLeavesBeforeItIsWritten() throws Exception {
        List<Long> heard = Collections.synchronizedList(new ArrayList<>());
        try (SqliteJournal journal = SqliteJournal.create(file, Tour.HEADER, JournalOptions.DEFAULT);
                EngineHost host = host(journal, 0);
                Connection other = DriverManager.getConnection("jdbc:sqlite:" + file);
                Statement lock = other.createStatement()) {
            host.addListener((index, at, input, effects, view) -> heard.add(index));
            lock.execute("BEGIN IMMEDIATE");
            host.post(batch(1));
            assertThat(stepped.await(60, TimeUnit.SECONDS)).isTrue();
            assertThat(heard).isEmpty();
            lock.execute("ROLLBACK");

            int missions = host.ask(view -> view.missions().size()); // not before the batch has left
            assertThat(missions).isEqualTo(10);
            assertThat(heard).isEqualTo(LongStream.rangeClosed(1, SIZE).boxed().toList());
        }
    }

    @Test
    void whatIsPostedBeforeTheHostIsClosedIsInTheFile() throws Exception {
        try (SqliteJournal journal = SqliteJournal.create(file, Tour.HEADER, JournalOptions.DEFAULT)) {
            EngineHost host = host(journal, 0);
            for (int i = 0; i < 5; i++) {
                host.post(batch(i));
            }
            host.close();
            assertThat(host.status().kind()).isEqualTo(Kind.CLOSED);
            assertThat(journal.lastIndex()).isEqualTo(5 * SIZE);
        }

        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(StateCodec.encode(reader.stateAt(reader.lastIndex(), HostPlans.engine())))
                    .isEqualTo(StateCodec.encode(state));
        }
    }

    @Test
    void anErrorOfTheEngineInTheMiddleLeavesNothingOfTheBatch() throws Exception {
        List<Long> heard = Collections.synchronizedList(new ArrayList<>());
        try (SqliteJournal journal = SqliteJournal.create(file, Tour.HEADER, JournalOptions.DEFAULT)) {
            EngineHost host = host(journal, SIZE + 600);
            host.addListener((index, at, input, effects, view) -> heard.add(index));
            host.post(batch(1));
            host.query(EngineView::missions).get(60, TimeUnit.SECONDS);
            host.post(batch(2));
            host.close();

            assertThat(host.status().kind()).isEqualTo(Kind.FAILED);
            assertThat(host.status().details())
                    .isEqualTo("at entry 1001 or after: java.lang.IllegalStateException: a fault of the engine");
            assertThat(heard).hasSize(SIZE);
        }
        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(reader.lastIndex()).isEqualTo(SIZE);
            assertThat(reader.recovery().damage()).isEmpty();
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 7, 30})
    void aKilledProcessLeavesWholeBatchesAndTheStateThatItHad(int after) throws Exception {
        Process writer = JavaProcess.builder(folder, Writer.class, file.toString())
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        long index = 0;
        String hash = "";
        try (BufferedReader lines = writer.inputReader(StandardCharsets.UTF_8)) {
            for (int i = 0; i < after; i++) {
                String[] words = lines.readLine().split(" ");
                index = Long.parseLong(words[0]);
                hash = words[1];
            }
            writer.destroyForcibly().waitFor();
        }

        try (SqliteJournal journal = SqliteJournal.open(file, JournalOptions.DEFAULT)) {
            assertThat(journal.recovery().damage()).isEmpty();
            assertThat(journal.lastIndex()).isGreaterThanOrEqualTo(index);
            assertThat(journal.lastIndex() % SIZE).as("all of a batch or none").isZero();
        }
        try (JournalReader reader = JournalReader.open(file)) {
            assertThat(hash(reader.stateAt(index, HostPlans.engine()))).isEqualTo(hash);
        }
    }

    private static String hash(EngineState state) {
        return HexFormat.of().toHexDigits(Arrays.hashCode(StateCodec.encode(state)));
    }

    /** Hosts an engine until it is killed, and says after each batch where it is and what the state is. */
    static final class Writer {
        private Writer() {}

        public static void main(String[] args) throws IOException {
            Engine engine = HostPlans.engine();
            EngineState state = engine.newState();
            try (SqliteJournal journal = SqliteJournal.create(
                            Path.of(args[0]), Tour.HEADER, JournalOptions.DEFAULT.withPages(4096, 20));
                    MonotonicHostClock clock = new MonotonicHostClock(0);
                    EngineHost host = EngineHostBuilder.of(engine, state)
                            .journal(journal)
                            .clock(clock)
                            .executor(Runnable::run)
                            .build()) {
                host.addListener((index, at, input, effects, view) -> {
                    if (index % SIZE == 0) {
                        System.out.println(index + " " + hash(state));
                    }
                });
                for (long n = 1; host.post(batch(n)); n++) {
                    host.post(ending(n));
                }
            }
        }
    }

    /** The engine with its state; says how many inputs it took, and meets a fault at one of them. */
    private final class Watched implements EngineFunction {
        private final long faultAt;
        private long taken;

        Watched(long faultAt) {
            this.faultAt = faultAt;
        }

        @Override
        public void step(long nowMillis, Input input, Consumer<? super Effect> effects) {
            if (++taken == faultAt) {
                throw new IllegalStateException("a fault of the engine");
            }
            engine.step(state, nowMillis, input, effects);
            stepped.countDown();
        }

        @Override
        public EngineView view() {
            return engine.view(state);
        }

        @Override
        public byte[] encode() {
            return StateCodec.encode(state);
        }

        @Override
        public Vocabulary vocabulary() {
            return engine.vocabulary();
        }
    }
}
