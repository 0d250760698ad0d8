package org.sami.spn.host;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.sami.spn.host.HostPlans.start;

import java.util.List;
import java.util.Map;
import java.util.concurrent.RejectedExecutionException;
import org.junit.jupiter.api.Test;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;

/** What a host does with handlers of output events. */
class HostHandlersTest extends HostOnManualExecutor {
    @Test
    void aHandlerThatThrowsBecomesAnInputWithItsReason() {
        host.register(
                "Do",
                (activation, context) -> {
                    throw new IllegalStateException("no paint left");
                },
                Runnable::run);
        host.post(start("Do"));
        executor.runAll();

        assertThat(inputs()).containsExactly(start("Do"), new Input.HandlerFailed(1, "no paint left"));
    }

    @Test
    void aHandlerWhoseExecutorRefusesBecomesAnInput() {
        host.register("Do", (activation, context) -> {}, refused -> {
            throw new RejectedExecutionException();
        });
        host.post(start("Do"));
        executor.runAll();

        assertThat(inputs())
                .containsExactly(start("Do"), new Input.HandlerFailed(1, "the handler of Do takes no more work"));
    }

    @Test
    void anEventThatNothingHandlesBecomesAnInput() {
        host.post(start("Drive"));
        executor.runAll();

        assertThat(inputs()).containsExactly(start("Drive"), new Input.HandlerFailed(1, "nothing handles Drive"));
    }

    @Test
    void decisionsRolesOfTheEngineAndMessagesNeedNoHandler() {
        List<Input> posted = List.of(start("Approve"), start("GetAll"), start("timer"), start("Tell"));
        host.post(posted);
        executor.runAll();

        assertThat(inputs()).isEqualTo(posted);
    }

    @Test
    void aTypeHasOneHandlerAtATime() {
        Registration first = host.register("Do", (activation, context) -> log.add("first"), Runnable::run);

        assertThatThrownBy(() -> host.register("Do", (activation, context) -> {}, Runnable::run))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("Do");

        first.close();
        host.register("Do", (activation, context) -> log.add("second"), Runnable::run);
        host.post(start("Do"));
        executor.runAll();
        assertThat(log).contains("second").doesNotContain("first");
    }

    @Test
    void aHandlerPostsItsAnswerAndAsksTheState() {
        host.register(
                "Do",
                (activation, context) -> {
                    assertThat(context.redelivered()).isFalse();
                    assertThat(context.query(EngineView::missions)).hasSize(1);
                    context.post(
                            new Input.Received(Occurrence.answer("Done", activation, List.of(), List.of(), Map.of())));
                },
                Runnable::run);
        host.post(start("Do"));
        executor.runAll();

        assertThat(inputs()).hasSize(2);
        assertThat(host.ask(EngineView::missions)).isEmpty();
    }

    @Test
    void aResumedHostDeliversOpenActivationsAgainAndArmsItsTimers() {
        host.register("Do", (activation, context) -> log.add("first " + activation.id()), Runnable::run);
        host.post(List.of(start("Do"), start("timer")));
        executor.runAll();

        WatchedJournal same = journal;
        ManualClock laterClock = new ManualClock();
        try (EngineHost resumed = EngineHostBuilder.of(engine, state.copy())
                .journal(same)
                .clock(laterClock)
                .executor(executor)
                .build()) {
            resumed.register(
                    "Do",
                    (activation, context) -> log.add(
                            "again " + activation.id() + " " + context.redelivered() + " " + context.orderedAgain()),
                    Runnable::run);
            resumed.resume();
            assertThat(log).endsWith("sync", "again 1 true false");
            resumed.redeliver(1);
            assertThat(log).as("by somebody's order").endsWith("again 1 true true");

            laterClock.moveTo(1000);
            executor.runAll();
            assertThat(inputs()).endsWith(new Input.TimeReached());
        }
    }
}
