package org.sami.bench;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.sami.spn.engine.Engine;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.EngineHostBuilder;
import org.sami.spn.host.HostStatus;
import org.sami.spn.host.MonotonicHostClock;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.journal.SqliteJournal;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;

/** What one input costs a host with its journal on disk, a handler and snapshots included. */
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
public class JournalBenchmarks {
    private static final int ROBOTS = 250;
    private static final int MISSIONS = 4;

    /** A session in which every robot of every mission reports in turn. The handler wakes who waits once a round, not for each answer: that would be measured too. */
    @State(Scope.Thread)
    public static class Session {
        private final Map<Long, Map<String, Activation>> asked = new LinkedHashMap<>();
        private volatile CountDownLatch outstanding = new CountDownLatch(MISSIONS);
        private Path folder;
        private SqliteJournal journal;
        private MonotonicHostClock clock;
        private ExecutorService thread;
        private EngineHost host;

        /** Starts over, with a file of its own. */
        @Setup(Level.Iteration)
        public void start() throws IOException, InterruptedException {
            folder = Files.createTempDirectory("journal-benchmark");
            journal = SqliteJournal.create(
                    folder.resolve("session.journal"),
                    JournalHeader.of("", Map.of(), Map.of()),
                    JournalOptions.DEFAULT);
            clock = new MonotonicHostClock(0);
            thread = Executors.newSingleThreadExecutor();
            Engine engine = Rings.robots(10);
            host = EngineHostBuilder.of(engine, engine.newState())
                    .journal(journal)
                    .clock(clock)
                    .executor(thread)
                    .build();
            asked.clear();
            outstanding = new CountDownLatch(MISSIONS);
            host.register("Do", (activation, context) -> keep(activation), Runnable::run);
            for (int i = 0; i < ROBOTS; i++) {
                host.post(new Input.ProxyJoined("robot" + i));
            }
            for (int m = 0; m < MISSIONS; m++) {
                host.post(new Input.StartMission("ring", "ring", Map.of()));
            }
            outstanding.await();
        }

        /** Ends the session and deletes its file. */
        @TearDown(Level.Iteration)
        public void end() throws IOException {
            host.close();
            if (host.status().kind() != HostStatus.Kind.CLOSED) {
                throw new IllegalStateException(host.status().reason());
            }
            thread.shutdown();
            clock.close();
            journal.close();
            try (DirectoryStream<Path> files = Files.newDirectoryStream(folder)) {
                for (Path file : files) {
                    Files.delete(file);
                }
            }
            Files.delete(folder);
        }

        private void keep(Activation activation) {
            Map<String, Activation> ofMission =
                    asked.computeIfAbsent(activation.mission(), mission -> new LinkedHashMap<>());
            for (Token token : activation.tokens()) {
                if (token instanceof Token.Proxy robot) {
                    ofMission.put(robot.proxy(), activation);
                }
            }
            outstanding.countDown();
        }

        private void round() throws InterruptedException {
            List<Input> answers = new ArrayList<>(ROBOTS * MISSIONS);
            for (Map<String, Activation> ofMission : asked.values()) {
                ofMission.forEach((robot, question) -> answers.add(
                        new Input.Received(Occurrence.answer("Done", question, List.of(robot), List.of(), Map.of()))));
            }
            outstanding = new CountDownLatch(answers.size());
            answers.forEach(host::post);
            outstanding.await();
        }
    }

    /** engine.journalled: posted one by one, processed, durable, and answered by a handler. */
    @Benchmark
    @OperationsPerInvocation(ROBOTS * MISSIONS)
    public void journalled(Session session) throws InterruptedException {
        session.round();
    }
}
