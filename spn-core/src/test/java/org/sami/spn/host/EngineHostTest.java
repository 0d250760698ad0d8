package org.sami.spn.host;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.sami.spn.host.HostPlans.number;
import static org.sami.spn.host.HostPlans.numberOf;
import static org.sami.spn.host.HostPlans.start;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.RejectedExecutionException;
import org.junit.jupiter.api.Test;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;

/** What a host promises, with an executor that the test turns by hand. */
class EngineHostTest {
    private final List<String> log = new ArrayList<>();
    private final WatchedJournal journal = new WatchedJournal(log);
    private final ManualExecutor executor = new ManualExecutor();
    private final ManualClock clock = new ManualClock();
    private final Engine engine = HostPlans.engine();
    private final EngineState state = engine.newState();
    private final EngineHost host = builder().build();

    private EngineHostBuilder builder() {
        return EngineHostBuilder.of(engine, state).journal(journal).clock(clock).executor(executor);
    }

    private List<Input> inputs() {
        return journal.entries().stream().map(JournalEntry::input).toList();
    }

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
    void replyComesOnceItsInputIsDurableAndBeforeTheListenersHearOfTheStep() {
        host.addListener((index, at, input, effects, view) -> log.add("heard " + index));
        Input same = number(1);
        host.post(same, effects -> log.add("first reply"));
        host.post(same, effects -> log.add("second reply"));
        executor.runAll();

        assertThat(log)
                .containsExactly(
                        "append to 2 PROCESS", "first reply", "heard 1", "second reply", "heard 2", "snapshot offered");
    }

    @Test
    void replyBringsWhatFollowedFromItsInputAlone() {
        List<Effect> followed = new ArrayList<>();
        host.post(start("Do"));
        host.post(start("Do"), followed::addAll);
        executor.runAll();

        assertThat(followed).filteredOn(Effect.MissionStarted.class::isInstance).hasSize(1);
    }

    @Test
    void replyThatThrowsStopsNeitherTheHostNorItsListeners() {
        host.addListener((index, at, input, effects, view) -> log.add("heard " + index));
        host.post(number(1), effects -> {
            throw new IllegalStateException("thrown by the test");
        });
        host.post(number(2));
        executor.runAll();

        assertThat(log).contains("heard 1", "heard 2");
        assertThat(host.status().kind()).isEqualTo(HostStatus.Kind.RUNNING);
    }

    @Test
    void inputThatIsRefusedGetsNoReply() {
        host.close();

        assertThat(host.post(number(1), effects -> log.add("replied"))).isFalse();
        executor.runAll();
        assertThat(log).doesNotContain("replied");
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
    void aListenerThatThrowsHarmsNeitherEngineNorOthers() {
        List<Long> heard = new ArrayList<>();
        host.addListener((index, at, input, effects, view) -> {
            throw new IllegalStateException("broken listener");
        });
        host.addListener((index, at, input, effects, view) -> heard.add(index));
        host.post(List.of(number(1), number(2)));
        executor.runAll();

        assertThat(heard).containsExactly(1L, 2L);
        assertThat(host.status().kind()).isEqualTo(HostStatus.Kind.RUNNING);
        assertThat(host.load().listenerFaults()).isEqualTo(2);
    }

    @Test
    void aListenerThatHoldsTheEngineIsReported() {
        try (EngineHost strict = builder().slowListenerMillis(0).build()) {
            strict.addListener((index, at, input, effects, view) -> view.missions());
            strict.post(number(1));
            executor.runAll();

            assertThat(strict.load().slowListeners()).isEqualTo(1);
        }
    }

    @Test
    void aListenerThatWasTakenAwayHearsNothingMore() {
        List<Long> heard = new ArrayList<>();
        Registration registration = host.addListener((index, at, input, effects, view) -> heard.add(index));
        host.post(number(1));
        executor.runAll();
        registration.close();
        host.post(number(2));
        executor.runAll();

        assertThat(heard).containsExactly(1L);
    }

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
    void aTimerWakesTheEngineWhenItIsDue() {
        host.post(start("timer"));
        executor.runAll();
        clock.moveTo(999);
        executor.runAll();
        assertThat(inputs()).hasSize(1);

        clock.moveTo(1000);
        executor.runAll();

        assertThat(journal.entries().get(1)).isEqualTo(new JournalEntry(2, 1000, new Input.TimeReached()));
        assertThat(host.ask(EngineView::missions)).isEmpty();
    }

    @Test
    void aTimerThatEndedWakesNobody() {
        host.post(start("timer"));
        executor.runAll();
        host.post(new Input.AbortMission(1));
        executor.runAll();

        clock.moveTo(5000);
        executor.runAll();

        assertThat(inputs()).hasSize(2);
    }

    @Test
    void timeInTheJournalNeverGoesBack() {
        clock.moveTo(500);
        host.post(number(1));
        executor.runAll();
        clock.moveTo(400);
        host.post(number(2));
        executor.runAll();

        assertThat(journal.entries()).extracting(JournalEntry::atMillis).containsExactly(500L, 500L);
    }

    @Test
    void telemetryIsNoInputUnlessATransitionWaitsForIt() {
        host.postIfAwaited(pose("boat-1"));
        executor.runAll();
        assertThat(inputs()).isEmpty();

        host.post(start("watch"));
        executor.runAll();
        host.postIfAwaited(pose("boat-1"));
        executor.runAll();
        assertThat(inputs()).containsExactly(start("watch"), new Input.Received(pose("boat-1")));

        host.postIfAwaited(pose("boat-1"));
        executor.runAll();
        assertThat(inputs()).as("the mission ended, nothing waits any longer").hasSize(2);
    }

    @Test
    void onlyTheLatestTelemetryOfEachProxyWaits() {
        host.post(start("watch"));
        executor.runAll();
        for (int i = 0; i < 10; i++) {
            host.postIfAwaited(pose("boat-1"));
            host.postIfAwaited(pose("boat-2"));
        }
        executor.runAll();

        assertThat(inputs())
                .containsExactly(
                        start("watch"), new Input.Received(pose("boat-1")), new Input.Received(pose("boat-2")));
        assertThat(host.load().telemetryReplaced()).isEqualTo(18);
    }

    @Test
    void newsThatIsNoTelemetryIsAlwaysAnInput() {
        Occurrence news = Occurrence.news("News", List.of(), Map.of());
        host.postIfAwaited(news);
        executor.runAll();

        assertThat(inputs()).containsExactly(new Input.Received(news));
    }

    @Test
    void aQuestionIsAnsweredOnTheEnginesExecutorAndAtOnceOnItsThread() {
        CompletableFuture<Integer> early = host.query(view -> view.missions().size());
        assertThat(early).isNotDone();
        host.post(start("Tell"));
        List<Integer> heard = new ArrayList<>();
        host.addListener((index, at, input, effects, view) ->
                heard.add(host.query(v -> v.missions().size()).join()));
        executor.runAll();

        assertThat(early).isCompletedWithValue(0);
        assertThat(heard).containsExactly(1);
        assertThat(host.query(view -> view.missions().size())).isCompletedWithValue(1);
    }

    @Test
    void aQuestionThatThrowsFailsItsAsker() {
        CompletableFuture<Object> answer = host.query(view -> {
            throw new IllegalArgumentException("bad question");
        });
        executor.runAll();

        assertThat(answer).isCompletedExceptionally();
        assertThat(host.status().kind()).isEqualTo(HostStatus.Kind.RUNNING);
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
                    (activation, context) -> log.add("again " + activation.id() + " " + context.redelivered()),
                    Runnable::run);
            resumed.resume();
            assertThat(log).endsWith("sync", "again 1 true");

            laterClock.moveTo(1000);
            executor.runAll();
            assertThat(inputs()).endsWith(new Input.TimeReached());
        }
    }

    @Test
    void aBatchOfOneShowsListenersTheExactState() {
        try (EngineHost exact = builder().batchLimit(1).build()) {
            List<Long> seen = new ArrayList<>();
            exact.addListener((index, at, input, effects, view) ->
                    seen.add(view.variable(0, "@n").isPresent() ? numberOf(input) : -1));
            exact.post(number(1));
            exact.post(number(2));
            executor.runAll();

            assertThat(seen).containsExactly(1L, 2L);
            assertThat(exact.load().batches()).isEqualTo(2);
        }
    }

    private static Occurrence pose(String proxy) {
        return Occurrence.news("Pose", List.of(proxy), Map.of());
    }
}
