package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.EngineHostBuilder;
import org.sami.spn.host.HostClock;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;

/** Abort, interrupt, answer and autonomy's timer around the moment in which the timer runs out: exactly one of them wins. */
class DecisionRaceTest {
    private static final long TIMEOUT_MS = 2000;
    private static final Project PROJECT =
            new ProjectReader(TestWorld.VOCABULARY).read("""
                    {"formatVersion": 1, "id": "p", "name": "race", "domain": "crw", "plans": [{"id": "p", "name": "race",
                     "places": [
                      {"id": "asking", "start": true, "outputs": [{"id": "ask", "type": "OperatorApprove",
                       "fields": {"question": {"value": "Go on?"}},
                       "markups": [{"type": "MixedInitiativeTrigger", "options": {"trigger": "TIMER", "timeout": "PT2S"}}]}]},
                      {"id": "done", "end": true}, {"id": "stopped", "end": true}],
                     "transitions": [
                      {"id": "yes", "inputs": [{"id": "i", "type": "YesOption"}]},
                      {"id": "stop", "inputs": [{"id": "j", "type": "OperatorInterruptReceived",
                       "fields": {"interruptName": "stop"}}]}],
                     "inEdges": [
                      {"id": "e1", "place": "asking", "transition": "yes",
                       "requirements": [{"kind": "generic", "match": "at-least", "n": 1}]},
                      {"id": "e2", "place": "asking", "transition": "stop",
                       "requirements": [{"kind": "generic", "match": "at-least", "n": 1}]}],
                     "outEdges": [
                      {"id": "e3", "transition": "yes", "place": "done",
                       "requirements": [{"kind": "generic", "action": "take", "n": 1}]},
                      {"id": "e4", "transition": "stop", "place": "stopped",
                       "requirements": [{"kind": "generic", "action": "take", "n": 1}]}]}]}
                    """).orThrow();

    private enum Contender {
        OPERATOR,
        ABORT,
        INTERRUPT,
        AUTONOMY
    }

    private static Input input(Contender contender, long mission, long decision) {
        return switch (contender) {
            case OPERATOR -> new Input.AnswerDecision(decision, new Answer.YesNo(true), Answerer.OPERATOR);
            case ABORT -> new Input.AbortMission(mission);
            case INTERRUPT -> new Input.Interrupt(mission, "stop", List.of());
            case AUTONOMY -> new Input.TimeReached();
        };
    }

    /** Who won, by all that is seen of it; fails where effects contradict one another or more than one had its way. */
    private static Contender winner(List<Effect> effects) {
        List<Effect.DecisionClosed> closed = only(effects, Effect.DecisionClosed.class);
        List<Effect.MissionEnded> ended = only(effects, Effect.MissionEnded.class);
        List<String> fired = only(effects, Effect.Fired.class).stream()
                .map(Effect.Fired::transition)
                .toList();
        assertThat(closed).as("closed once: %s", effects).hasSize(1);
        assertThat(ended).as("ended once: %s", effects).hasSize(1);
        Optional<Answerer> by = closed.get(0).by();
        if (by.isPresent()) {
            assertThat(fired).containsExactly("yes");
            assertThat(ended.get(0).outcome()).isEqualTo(Outcome.ENDED);
            return by.get() == Answerer.AUTONOMY ? Contender.AUTONOMY : Contender.OPERATOR;
        } else if (fired.isEmpty()) {
            assertThat(ended.get(0).outcome()).isEqualTo(Outcome.ABORTED);
            return Contender.ABORT;
        }
        assertThat(fired).containsExactly("stop");
        assertThat(ended.get(0).outcome()).isEqualTo(Outcome.ENDED);
        return Contender.INTERRUPT;
    }

    private static <T extends Effect> List<T> only(List<Effect> effects, Class<T> type) {
        return effects.stream().filter(type::isInstance).map(type::cast).toList();
    }

    private static List<List<Contender>> orders(Set<Contender> left) {
        if (left.isEmpty()) {
            return List.of(List.of());
        }
        List<List<Contender>> all = new ArrayList<>();
        for (Contender first : left) {
            Set<Contender> rest = EnumSet.copyOf(left);
            rest.remove(first);
            orders(rest).forEach(order -> {
                List<Contender> whole = new ArrayList<>(List.of(first));
                whole.addAll(order);
                all.add(whole);
            });
        }
        return all;
    }

    /** Before the moment the first to come wins; from that moment on it is autonomy's, whoever comes first. */
    @ParameterizedTest
    @ValueSource(longs = {-1, 0, 1})
    void exactlyOneWinsInEveryOrder(long aroundMs) {
        for (List<Contender> order : orders(EnumSet.allOf(Contender.class))) {
            Engine engine = new Engine(TestWorld.VOCABULARY, PROJECT);
            EngineState state = engine.newState();
            List<Effect> effects = new ArrayList<>();
            engine.step(state, 0, new Input.StartMission("p", "race", Map.of()), effects::add);
            long mission = engine.view(state).missions().get(0).id();
            long decision = engine.view(state).decisions().get(0).id();

            order.forEach(contender ->
                    engine.step(state, TIMEOUT_MS + aroundMs, input(contender, mission, decision), effects::add));

            Contender first = order.stream()
                    .filter(contender -> contender != Contender.AUTONOMY)
                    .findFirst()
                    .orElseThrow();
            assertThat(winner(effects)).as("%s", order).isEqualTo(aroundMs < 0 ? first : Contender.AUTONOMY);
        }
    }

    /** A clock that a test sets. */
    private static final class SetClock implements HostClock {
        private final AtomicLong nowMs = new AtomicLong();

        @Override
        public long nowMillis() {
            return nowMs.get();
        }

        @Override
        public void wakeAt(long millis, Runnable action) {}
    }

    /** Each from a thread of its own, just before the timer runs out and at that moment. */
    @Test
    void exactlyOneWinsWhenAllComeAtOnce() throws Exception {
        ExecutorService threads = Executors.newFixedThreadPool(Contender.values().length);
        ExecutorService own = Executors.newSingleThreadExecutor();
        try {
            for (int round = 0; round < 200; round++) {
                SetClock clock = new SetClock();
                Engine engine = new Engine(TestWorld.VOCABULARY, PROJECT);
                EngineHost host = EngineHostBuilder.of(engine, engine.newState())
                        .clock(clock)
                        .executor(own)
                        .build();
                List<Effect> effects =
                        new ArrayList<>(); // for the host's thread, then after its last step for this one
                host.addListener((index, atMillis, input, stepped, view) -> effects.addAll(stepped));
                host.post(new Input.StartMission("p", "race", Map.of()));
                own.submit(() -> {}).get(); // what was posted before is done
                long mission = host.ask(view -> view.missions().get(0).id());
                long decision = host.ask(view -> view.decisions().get(0).id());
                clock.nowMs.set(TIMEOUT_MS - 1 + round % 2);
                CyclicBarrier start = new CyclicBarrier(Contender.values().length);
                List<Future<?>> posted = new ArrayList<>();
                for (Contender contender : Contender.values()) {
                    posted.add(threads.submit(() -> {
                        start.await();
                        host.post(input(contender, mission, decision));
                        return null;
                    }));
                }
                for (Future<?> one : posted) {
                    one.get();
                }
                host.close(); // processes what was taken in and waits still

                Contender winner = winner(effects);
                assertThat(winner == Contender.AUTONOMY).isEqualTo(round % 2 == 1);
            }
        } finally {
            threads.shutdownNow();
            own.shutdownNow();
        }
    }
}
