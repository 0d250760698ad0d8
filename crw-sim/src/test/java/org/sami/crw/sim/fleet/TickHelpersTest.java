package org.sami.crw.sim.fleet;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.server.testing.ProcessClock;

@Timeout(900)
class TickHelpersTest {

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 3})
    void everyNumberIsDoneOnceHoweverManyHelp(int count) {
        try (TickHelpers helpers = new TickHelpers(count)) {
            for (int size : List.of(0, 1, 7, 8, 250)) {
                AtomicIntegerArray done = new AtomicIntegerArray(size);
                for (int round = 0; round < 200; round++) {
                    forEach(helpers, size, done::incrementAndGet);
                }
                assertThat(IntStream.range(0, size).map(done::get)).allMatch(times -> times == 200);
            }
        }
    }

    @Test
    void helperTakesPartAgainAfterItHasSlept() {
        try (TickHelpers helpers = new TickHelpers(1)) {
            Thread helper = helperIn(helpers);
            for (int round = 0; round < 3; round++) {
                while (helper.getState() != Thread.State.WAITING) {
                    Thread.onSpinWait();
                }

                assertThat(helperIn(helpers)).isSameAs(helper);
            }
        }
    }

    @Test
    void ofSeveralFaultsThatOfTheLeastNumberIsThrownAndTheRestIsDone() {
        try (TickHelpers helpers = new TickHelpers(2)) {
            AtomicIntegerArray done = new AtomicIntegerArray(100);

            assertThatThrownBy(() -> forEach(helpers, 100, i -> {
                        done.incrementAndGet(i);
                        if (i % 30 == 29) {
                            throw new IllegalStateException("boat " + i);
                        }
                    }))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessage("boat 29");

            assertThat(IntStream.range(0, 100).map(done::get)).allMatch(times -> times == 1);
        }
    }

    @Test
    void callerDoesAllItselfOnceHelpersHaveEnded() throws InterruptedException {
        TickHelpers helpers = new TickHelpers(1);
        Thread helper = helperIn(helpers);
        helpers.close();
        helper.join();
        Set<Thread> threads = ConcurrentHashMap.newKeySet();

        forEach(helpers, 100, i -> threads.add(Thread.currentThread()));

        assertThat(threads).containsExactly(Thread.currentThread());
    }

    @Test
    void callerDoesAllItselfForAWhileAfterAHelperLostItsCoreAndLongerWhereThatHappensAgain() {
        try (TickHelpers helpers = new TickHelpers(1)) {
            Thread helper = helperIn(helpers);

            loseCore(helpers, helper);
            assertThat(threadsOf(50, helpers)).containsExactly(Thread.currentThread());
            assertThat(helperIn(helpers)).isSameAs(helper);

            loseCore(helpers, helper); // again, and soon
            assertThat(threadsOf(100, helpers)).containsExactly(Thread.currentThread());
            assertThat(helperIn(helpers)).isSameAs(helper);
        }
    }

    /** The helper loses its core in the middle of its work; until it is at work it is begun again. */
    private static void loseCore(TickHelpers helpers, Thread helper) {
        CountDownLatch helperIsAtWork = new CountDownLatch(1);
        while (helperIsAtWork.getCount() > 0) {
            AtomicBoolean hasWaited = new AtomicBoolean();
            forEach(helpers, 100, i -> {
                if (Thread.currentThread() != helper) {
                    if (!hasWaited.getAndSet(true)) {
                        await(helperIsAtWork);
                    }
                } else if (helperIsAtWork.getCount() > 0) {
                    helperIsAtWork.countDown();
                    standStill();
                }
            });
        }
    }

    /** The threads that do what is to be done so many times. */
    private static Set<Thread> threadsOf(int times, TickHelpers helpers) {
        Set<Thread> threads = ConcurrentHashMap.newKeySet();
        for (int i = 0; i < times; i++) {
            forEach(helpers, 100, at -> threads.add(Thread.currentThread()));
        }
        return threads;
    }

    /** As a thread does whose core has gone to another process, for so long that the caller has to see it. */
    private static void standStill() {
        long untilMs = ProcessClock.ms() + 100;
        while (ProcessClock.ms() < untilMs) {
            Thread.onSpinWait();
        }
    }

    /**
     * Has both threads work at once; gives the one that is not the caller's. Where the machine has taken the helper's core the caller is alone for a
     * while, and it is begun again.
     */
    private static Thread helperIn(TickHelpers helpers) {
        Set<Thread> threads = ConcurrentHashMap.newKeySet();
        while (threads.size() < 2) {
            CountDownLatch bothAreThere = new CountDownLatch(2);
            threads.clear();
            forEach(helpers, 100, i -> {
                if (threads.add(Thread.currentThread())) {
                    bothAreThere.countDown();
                    await(bothAreThere);
                }
            });
        }
        threads.remove(Thread.currentThread());
        assertThat(threads).hasSize(1);
        return threads.iterator().next();
    }

    private static void forEach(TickHelpers helpers, int size, IntConsumer action) {
        helpers.begin(size, action);
        helpers.await();
    }

    /** Waits for another thread, but not for long: it may take no part. */
    private static void await(CountDownLatch latch) {
        try {
            latch.await(20, TimeUnit.MILLISECONDS);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }
}
