package org.sami.spn.host;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.spn.host.HostPlans.number;
import static org.sami.spn.host.HostPlans.numberOf;
import static org.sami.spn.host.HostPlans.start;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/** What a host does with listeners, replies and questions. */
class HostListenersTest extends HostOnManualExecutor {
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
}
