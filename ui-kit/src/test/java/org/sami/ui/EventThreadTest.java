package org.sami.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class EventThreadTest {
    @Test
    void runsTasksInTheirOrderOnTheEventThread() throws Exception {
        StringBuilder order = new StringBuilder();
        CompletableFuture<Boolean> there = new CompletableFuture<>();

        EventThread.executor().execute(() -> order.append('a'));
        EventThread.later(() -> order.append('b'));
        EventThread.later(() -> there.complete(EventThread.isCurrent()));

        assertThat(there.get(60, TimeUnit.SECONDS)).isTrue();
        assertThat(order).hasToString("ab");
    }

    @Test
    void refusesAnotherThreadAndNamesIt() throws Exception {
        assertThat(EventThread.isCurrent()).isFalse();
        assertThatIllegalStateException()
                .isThrownBy(EventThread::require)
                .withMessageContaining(Thread.currentThread().getName());

        CompletableFuture<Void> checked = new CompletableFuture<>();
        EventThread.later(() -> {
            assertThatCode(EventThread::require).doesNotThrowAnyException();
            checked.complete(null);
        });
        checked.get(60, TimeUnit.SECONDS);
    }
}
