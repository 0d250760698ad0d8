package org.sami.spn.host;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.spn.host.HostPlans.number;
import static org.sami.spn.host.HostPlans.numberOf;
import static org.sami.spn.host.HostPlans.start;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;

/** A host under real threads. */
@Timeout(900)
class EngineHostThreadsTest {
    private static final int THREADS = 8;
    private static final int EACH = 3000;
    private static final long THREAD_STEP = 1_000_000;

    private final MemoryJournal journal = new MemoryJournal();
    private final ExecutorService engineThread = Executors.newSingleThreadExecutor();
    private final ExecutorService others = Executors.newCachedThreadPool();
    private final MonotonicHostClock clock = new MonotonicHostClock(0);
    private final Engine engine = HostPlans.engine();
    private final EngineHost host = EngineHostBuilder.of(engine, engine.newState())
            .journal(journal)
            .clock(clock)
            .executor(engineThread)
            .batchLimit(64)
            .build();

    @AfterEach
    void endThreads() {
        host.close();
        clock.close();
        engineThread.shutdownNow();
        others.shutdownNow();
    }

    @Test
    void postingFromManyThreadsLosesNothingAndKeepsTheOrderOfEach() throws Exception {
        CyclicBarrier together = new CyclicBarrier(THREADS);
        List<Thread> posters = new ArrayList<>();
        for (int t = 0; t < THREADS; t++) {
            long base = t * THREAD_STEP;
            Thread poster = new Thread(() -> {
                awaitAll(together);
                for (int i = 0; i < EACH; i += 3) {
                    host.post(List.of(number(base + i), number(base + i + 1), number(base + i + 2)));
                }
            });
            posters.add(poster);
            poster.start();
        }
        for (Thread poster : posters) {
            poster.join();
        }
        host.close();

        List<Long> numbers =
                journal.entries().stream().map(entry -> numberOf(entry.input())).toList();
        assertThat(numbers).hasSize(THREADS * EACH);
        Map<Long, Long> next = new HashMap<>();
        for (long number : numbers) {
            long thread = number / THREAD_STEP;
            assertThat(number % THREAD_STEP).isEqualTo(next.getOrDefault(thread, 0L));
            next.merge(thread, 1L, Long::sum);
        }
        for (int i = 0; i < numbers.size(); i += 3) {
            assertThat(numbers.get(i + 2)).as("a posting stays together").isEqualTo(numbers.get(i) + 2);
        }
    }

    @Test
    void handlersOnTheirOwnThreadsAnswerEveryMission() throws Exception {
        int missions = 500;
        CountDownLatch ended = new CountDownLatch(missions);
        host.addListener((index, at, input, effects, view) -> effects.stream()
                .filter(org.sami.spn.protocol.Effect.MissionEnded.class::isInstance)
                .forEach(e -> ended.countDown()));
        host.register(
                "Do",
                (activation, context) -> {
                    assertThat(context.query(EngineView::openActivations)).isNotNull();
                    context.post(
                            new Input.Received(Occurrence.answer("Done", activation, List.of(), List.of(), Map.of())));
                },
                others);
        for (int i = 0; i < missions; i++) {
            host.post(start("Do"));
        }

        assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
        assertThat(journal.entries()).hasSize(2 * missions);
    }

    @Test
    void aQuestionFromAnotherThreadNeverSeesHalfABatch() throws Exception {
        AtomicReference<Long> odd = new AtomicReference<>();
        CountDownLatch done = new CountDownLatch(1);
        others.execute(() -> {
            while (done.getCount() > 0) {
                long open = host.ask(view -> (long) view.missions().size());
                if (open % 2 != 0) {
                    odd.set(open);
                }
            }
        });
        for (int i = 0; i < 200; i++) {
            host.post(List.of(start("Tell"), start("Tell")));
        }
        assertThat(host.query(view -> view.missions().size()).get(60, TimeUnit.SECONDS) % 2)
                .isZero();
        done.countDown();

        assertThat(odd).hasValue(null);
    }

    @Test
    void realTimeRunsATimerDown() throws Exception {
        CountDownLatch ended = new CountDownLatch(1);
        host.addListener((index, at, input, effects, view) -> {
            if (input instanceof Input.TimeReached && view.missions().isEmpty()) {
                ended.countDown();
            }
        });
        host.post(start("timer"));

        assertThat(ended.await(60, TimeUnit.SECONDS)).isTrue();
        assertThat(journal.lastMillis()).isGreaterThanOrEqualTo(1000L);
    }

    @Test
    void aClosedHostLeavesNoThreadOfItsOwn() throws Exception {
        host.post(start("timer"));
        host.query(EngineView::missions).get(60, TimeUnit.SECONDS);
        host.close();
        clock.close();
        engineThread.shutdown();

        assertThat(engineThread.awaitTermination(60, TimeUnit.SECONDS)).isTrue();
        for (Thread thread : Thread.getAllStackTraces().keySet()) {
            if (thread.getName().equals("session-clock")) {
                thread.join(60_000);
                assertThat(thread.isAlive()).isFalse();
            }
        }
    }

    private static void awaitAll(CyclicBarrier barrier) {
        try {
            barrier.await();
        } catch (Exception broken) {
            throw new IllegalStateException(broken);
        }
    }
}
