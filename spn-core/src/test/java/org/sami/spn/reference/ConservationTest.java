package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.junit.jupiter.api.Test;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.MissionView;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.model.Action;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Token;
import org.sami.spn.protocol.TokenMove;
import org.sami.spn.testing.TestVocabulary;

/** What must be true of the engine on every random plan, whatever the rules say in particular. */
class ConservationTest {
    private static final int SEEDS = 400;
    private static final Map<Long, List<Scenario.Timed>> INPUTS = new ConcurrentHashMap<>();

    /** A random session of the engine, and what it did. */
    private static final class Run {
        final Project project;
        final Engine engine;
        final EngineState state;

        Run(long seed) {
            project = RandomPlans.project(seed);
            engine = new Engine(TestVocabulary.TEST, project, Scenario.LIVELOCK_LIMIT);
            state = engine.newState();
        }
    }

    /** Random inputs of a seed, as far as no place overflows: made once for all tests that use them, as the interpreter chooses them slowly. */
    static List<Scenario.Timed> inputs(long seed) {
        return INPUTS.computeIfAbsent(seed, ConservationTest::makeInputs);
    }

    private static List<Scenario.Timed> makeInputs(long seed) {
        Project project = RandomPlans.project(seed);
        Subject interpreter = Differential.interpreter(project);
        RandomInputs world = new RandomInputs(project, seed);
        List<Scenario.Timed> inputs = new ArrayList<>();
        try {
            for (int i = 0; i < 25; i++) {
                Scenario.Timed timed = world.next(interpreter);
                world.saw(interpreter.step(timed.nowMillis(), timed.input()));
                inputs.add(timed);
            }
        } catch (World.TooManyTokens e) {
            return List.copyOf(inputs);
        }
        return List.copyOf(inputs);
    }

    @Test
    void movesAccountForEveryChangeOfTheMarking() {
        int firings = 0;
        for (long seed = 1; seed <= SEEDS; seed++) {
            Run run = new Run(seed);
            for (Scenario.Timed timed : inputs(seed)) {
                Map<Long, Map<String, List<String>>> before = rootMarkings(run);
                List<Effect> effects = run.engine.step(run.state, timed.nowMillis(), timed.input());
                if (timed.input() instanceof Input.ProxyDropped) {
                    continue; // the operator takes tokens out, no firing does
                }
                Map<Long, Map<String, List<String>>> after = rootMarkings(run);
                firings += effects.stream()
                        .filter(Effect.Fired.class::isInstance)
                        .toList()
                        .size();
                before.keySet().retainAll(after.keySet());
                before.forEach((mission, marking) -> {
                    apply(marking, movesOf(mission, effects));
                    assertThat(sorted(marking)).as("Mission %d", mission).isEqualTo(sorted(after.get(mission)));
                });
            }
        }

        assertThat(firings).as("Firings looked at").isGreaterThan(1000);
    }

    /** Missions that run already and that no parent takes tokens from. */
    private static Map<Long, Map<String, List<String>>> rootMarkings(Run run) {
        Map<Long, Map<String, List<String>>> markings = new LinkedHashMap<>();
        for (MissionView m : run.engine.view(run.state).missions()) {
            if (m.parent() == 0 && m.status() != MissionStatus.WAITING) {
                Map<String, List<String>> marking = new LinkedHashMap<>();
                m.marking()
                        .forEach((place, tokens) -> marking.put(
                                place,
                                new ArrayList<>(
                                        tokens.stream().map(Token::toString).toList())));
                markings.put(m.id(), marking);
            }
        }
        return markings;
    }

    private static List<TokenMove> movesOf(long mission, List<Effect> effects) {
        List<TokenMove> moves = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.Fired f && f.mission() == mission) {
                moves.addAll(f.moves());
            }
        }
        return moves;
    }

    private static void apply(Map<String, List<String>> marking, List<TokenMove> moves) {
        for (TokenMove move : moves) {
            move.from()
                    .ifPresent(from -> assertThat(marking.getOrDefault(from, new ArrayList<>())
                                    .remove(move.token().toString()))
                            .as("%s was in %s", move.token(), from)
                            .isTrue());
            move.to()
                    .ifPresent(to -> marking.computeIfAbsent(to, key -> new ArrayList<>())
                            .add(move.token().toString()));
        }
    }

    private static Map<String, List<String>> sorted(Map<String, List<String>> marking) {
        Map<String, List<String>> result = new LinkedHashMap<>();
        marking.entrySet().stream()
                .filter(e -> !e.getValue().isEmpty())
                .sorted(Map.Entry.comparingByKey())
                .forEach(e -> result.put(
                        e.getKey(),
                        e.getValue().stream().sorted(Comparator.naturalOrder()).toList()));
        return result;
    }

    @Test
    void takingAloneNeitherMakesNorLosesTokens() {
        int firings = 0;
        for (long seed = 1; seed <= SEEDS; seed++) {
            Run run = new Run(seed);
            Set<String> takers = takers(run.project.plan("main").orElseThrow());
            for (Scenario.Timed timed : inputs(seed)) {
                Set<Long> mains = new LinkedHashSet<>();
                rootMarkings(run).keySet().forEach(mains::add);
                for (Effect effect : run.engine.step(run.state, timed.nowMillis(), timed.input())) {
                    if (effect instanceof Effect.Fired f
                            && mains.contains(f.mission())
                            && takers.contains(f.transition())) {
                        firings++;
                        assertThat(f.moves()).allMatch(m -> m.from().isPresent() && m.to().isPresent());
                    }
                }
            }
        }

        assertThat(firings).as("Firings looked at").isGreaterThan(100);
    }

    /** Transitions with one out edge that only takes from the pool. */
    private static Set<String> takers(Plan plan) {
        Set<String> takers = new LinkedHashSet<>();
        plan.transitions().forEach(t -> {
            List<OutEdge> out = plan.outEdgesOf(t.id());
            if (out.size() == 1
                    && out.get(0).requirements().stream()
                            .allMatch(r -> r.action() == Action.TAKE && r.kind() != TokenKind.SUB_MISSION_TOKENS)) {
                takers.add(t.id());
            }
        });
        return takers;
    }

    @Test
    void sameInputsGiveTheSameEffects() {
        for (long seed = 1; seed <= SEEDS; seed++) {
            Run first = new Run(seed);
            Run second = new Run(seed);
            for (Scenario.Timed timed : inputs(seed)) {
                assertThat(first.engine.step(first.state, timed.nowMillis(), timed.input()))
                        .as("Seed %d", seed)
                        .isEqualTo(second.engine.step(second.state, timed.nowMillis(), timed.input()));
            }
        }
    }

    @Test
    void decodedStateGoesOnLikeTheOneThatWasEncoded() {
        for (long seed = 1; seed <= SEEDS; seed++) {
            Run run = new Run(seed);
            EngineState restored = run.engine.newState();
            for (Scenario.Timed timed : inputs(seed)) {
                List<Effect> expected = run.engine.step(run.state, timed.nowMillis(), timed.input());
                assertThat(run.engine.step(restored, timed.nowMillis(), timed.input()))
                        .as("Seed %d", seed)
                        .isEqualTo(expected);
                byte[] bytes = StateCodec.encode(run.state);
                assertThat(StateCodec.encode(restored)).as("Seed %d", seed).isEqualTo(bytes);
                restored = StateCodec.decode(bytes, run.engine);
            }
        }
    }
}
