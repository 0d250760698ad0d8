package org.sami.spn.host;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.sami.spn.host.HostPlans.number;
import static org.sami.spn.host.HostPlans.start;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.RejectedExecutionException;
import org.junit.jupiter.api.Test;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;

/** What a host promises of order, journal, and end. */
class EngineHostTest extends HostOnManualExecutor {
    @Test
    void nothingHappensOnThePostingThread() {
        host.post(number(1));

        assertThat(journal.entries()).isEmpty();

        executor.runAll();
        assertThat(inputs()).containsExactly(number(1));
    }

    @Test
    void whatWaitsIsOneBatchOfTheJournal() {
        host.post(List.of(number(1), number(2)));
        host.post(number(3));
        executor.runAll();

        assertThat(log).containsExactly("append to 3 PROCESS", "snapshot offered");
        assertThat(host.load().batches()).isEqualTo(1);
        assertThat(host.load().mostQueued()).isEqualTo(3);
        assertThat(host.load().queued()).isZero();
    }

    @Test
    void aPostingIsNotDividedByTheLimitOfABatch() {
        try (EngineHost small = builder().batchLimit(2).build()) {
            small.post(number(1));
            small.post(List.of(number(2), number(3), number(4)));
            small.post(number(5));
            executor.runAll();
        }

        assertThat(log.stream().filter(line -> line.startsWith("append")))
                .containsExactly("append to 4 PROCESS", "append to 5 PROCESS");
    }

    @Test
    void effectsLeaveAfterTheirBatchIsDurableAndInOrder() {
        host.addListener((index, at, input, effects, view) -> log.add("heard " + index));
        host.register("Do", (activation, context) -> log.add("handled " + activation.id()), Runnable::run);
        host.post(List.of(start("Do"), number(1), start("Do")));
        executor.runAll();

        assertThat(log)
                .containsExactly(
                        "append to 3 PROCESS",
                        "heard 1",
                        "handled 1",
                        "heard 2",
                        "heard 3",
                        "handled 2",
                        "snapshot offered");
    }

    @Test
    void aJournalGetsALargeBatchPartByPartAndNothingLeavesBeforeAllOfItIsWritten() {
        host.addListener((index, at, input, effects, view) -> log.add("heard " + index));
        host.post(Collections.nCopies(300, number(1)));
        executor.runAll();

        assertThat(log)
                .hasSize(304)
                .startsWith("prepared to 128", "prepared to 256", "append to 300 PROCESS", "heard 1");
    }

    @Test
    void aBatchWithACommandSurvivesTheLossOfPowerBeforeTheCommandLeaves() {
        host.register("Drive", (activation, context) -> log.add("driven"), Runnable::run);
        host.post(start("Drive"));
        executor.runAll();

        assertThat(log).startsWith("append to 1 POWER", "driven");
    }

    @Test
    void whenTheJournalRefusesNothingLeavesAndTheHostSaysWhy() {
        List<String> stopped = new ArrayList<>();
        host.addListener(new HostListener() {
            @Override
            public void onStep(long index, long at, Input input, List<Effect> effects, EngineView view) {
                log.add("heard " + index);
            }

            @Override
            public void onFailed(HostStatus status) {
                stopped.add(status.reason());
            }
        });
        host.register("Do", (activation, context) -> log.add("handled"), Runnable::run);
        journal.refuse();
        host.post(start("Do"));
        executor.runAll();

        assertThat(log).isEmpty();
        assertThat(host.status())
                .isEqualTo(new HostStatus(HostStatus.Kind.FAILED, "the journal cannot be written: the disk is full"));
        assertThat(stopped).containsExactly("the journal cannot be written: the disk is full");
        assertThat(host.post(number(1))).isFalse();
        assertThat(host.load().refused()).isEqualTo(1);
        host.close();
        assertThat(host.status().kind()).isEqualTo(HostStatus.Kind.FAILED);
    }

    @Test
    void anExecutorThatRunsOnTheSpotIsEnough() {
        try (EngineHost direct = builder().executor(Runnable::run).build()) {
            direct.register(
                    "Do",
                    (activation, context) -> context.post(
                            new Input.Received(Occurrence.answer("Done", activation, List.of(), List.of(), Map.of()))),
                    Runnable::run);
            direct.post(start("Do"));

            assertThat(inputs()).hasSize(2);
            boolean taken = direct.ask(view -> direct.post(number(1)));
            assertThat(taken).isTrue();
            assertThat(inputs()).hasSize(3);
        }
    }

    @Test
    void closingProcessesWhatWasTakenInAndTakesInNoMore() {
        host.post(number(1));
        host.post(number(2));
        host.close();

        assertThat(inputs()).containsExactly(number(1), number(2));
        assertThat(log).endsWith("sync").doesNotContain("close");
        assertThat(host.post(number(3))).isFalse();
        executor.runAll();
        assertThat(inputs()).hasSize(2);
        assertThat(host.status().kind()).isEqualTo(HostStatus.Kind.CLOSED);
        host.close();
    }

    @Test
    void aListenerMayCloseTheHost() {
        host.addListener((index, at, input, effects, view) -> host.close());
        host.post(number(1));
        executor.runAll();

        assertThat(host.status().kind()).isEqualTo(HostStatus.Kind.CLOSED);
    }

    @Test
    void anEngineExecutorThatRefusesStopsTheTakingIn() {
        EngineHost orphan = builder()
                .executor(refused -> {
                    throw new RejectedExecutionException();
                })
                .build();
        orphan.post(number(1));

        assertThat(orphan.post(number(2))).isFalse();
        assertThat(orphan.load().refused()).isEqualTo(2);
        orphan.close();
    }

    @Test
    void aHostWithoutExecutorOrClockIsRefused() {
        assertThatThrownBy(() -> EngineHostBuilder.of(engine, state).build()).isInstanceOf(IllegalStateException.class);
    }
}
