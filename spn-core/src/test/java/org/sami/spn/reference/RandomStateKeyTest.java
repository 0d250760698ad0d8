package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.StateKey;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.TaskId;

/** Keys of states on every random plan: ids and the clock do not change them, all that can be seen does. */
class RandomStateKeyTest {
    private static final int SEEDS = 400;
    private static final long LATER = 123_456;

    /** How many ids a session gave before the inputs that are compared. */
    private record Shift(long missions, long activations, long decisions) {
        static Shift of(List<Effect> effects) {
            return new Shift(
                    effects.stream()
                            .filter(Effect.MissionStarted.class::isInstance)
                            .count(),
                    effects.stream().filter(Effect.Activated.class::isInstance).count(),
                    effects.stream()
                            .filter(Effect.DecisionOpened.class::isInstance)
                            .count());
        }

        long mission(long id) {
            return id == Ids.NONE ? id : id + missions;
        }

        TaskId task(TaskId task) {
            return new TaskId(mission(task.mission()), task.name());
        }

        Input input(Input input) {
            if (input instanceof Input.Received r) {
                Occurrence o = r.occurrence();
                long activation = o.activation() == Ids.NONE ? Ids.NONE : o.activation() + activations;
                List<TaskId> tasks = o.tasks().stream().map(this::task).toList();
                return new Input.Received(
                        new Occurrence(o.type(), mission(o.mission()), activation, o.proxies(), tasks, o.values()));
            } else if (input instanceof Input.AnswerDecision a) {
                return new Input.AnswerDecision(a.decision() + decisions, a.answer(), a.by());
            } else if (input instanceof Input.HoldDecision h) {
                return new Input.HoldDecision(h.decision() + decisions);
            } else if (input instanceof Input.Interrupt i) {
                return new Input.Interrupt(mission(i.mission()), i.name(), i.proxies());
            } else if (input instanceof Input.AbortMission a) {
                return new Input.AbortMission(mission(a.mission()));
            } else if (input instanceof Input.CompleteMission c) {
                return new Input.CompleteMission(mission(c.mission()));
            } else if (input instanceof Input.ProxyDropped d) {
                return new Input.ProxyDropped(d.proxy(), mission(d.mission()));
            } else if (input instanceof Input.SetVariable s) {
                return new Input.SetVariable(mission(s.mission()), s.variable(), s.value());
            } else if (input instanceof Input.AddTasks t) {
                return new Input.AddTasks(mission(t.mission()), t.tasks());
            } else if (input instanceof Input.AllocateTasks t) {
                Map<TaskId, Optional<String>> allocation = new LinkedHashMap<>();
                t.allocation().forEach((task, robot) -> allocation.put(task(task), robot));
                return new Input.AllocateTasks(allocation);
            }
            return input;
        }
    }

    @Test
    void idsAndTheClockDoNotChangeKeys() {
        int steps = 0;
        for (long seed = 1; seed <= SEEDS; seed++) {
            Project project = RandomPlans.project(seed);
            if (project.toString().contains("TaskId[")) {
                continue; // a plan that speaks of mission 1 by its id means another one here
            }
            Engine engine = new Engine(TestVocabulary.TEST, project, Scenario.LIVELOCK_LIMIT);
            EngineState used = engine.newState();
            List<Effect> before = new ArrayList<>(engine.step(used, 0, new Input.StartMission("main", "n", Map.of())));
            before.addAll(engine.step(used, LATER, new Input.AbortMission(Ids.NONE)));
            EngineState fresh = engine.newState();
            if (!StateKey.of(used).equals(StateKey.of(fresh))) {
                assertThat(engine.project().globals())
                        .as("Only globals outlive a mission")
                        .isNotEmpty();
                continue;
            }
            Shift shift = Shift.of(before);
            for (Scenario.Timed timed : ConservationTest.inputs(seed)) {
                engine.step(fresh, timed.nowMillis(), timed.input());
                engine.step(used, timed.nowMillis() + LATER, shift.input(timed.input()));
                assertThat(StateKey.of(used)).as("Seed %d", seed).isEqualTo(StateKey.of(fresh));
                steps++;
            }
        }

        assertThat(steps).as("Steps looked at").isGreaterThan(2000);
    }

    @Test
    void whatCanBeSeenToDifferHasAnotherKey() {
        int different = 0;
        for (long seed = 1; seed <= SEEDS; seed++) {
            Project project = RandomPlans.project(seed);
            Engine engine = new Engine(TestVocabulary.TEST, project, Scenario.LIVELOCK_LIMIT);
            EngineState state = engine.newState();
            Map<StateKey, List<Object>> met = new LinkedHashMap<>();
            for (Scenario.Timed timed : ConservationTest.inputs(seed)) {
                engine.step(state, timed.nowMillis(), timed.input());
                List<Object> seen = seen(engine.view(state), state, project);
                List<Object> before = met.put(StateKey.of(state), seen);
                if (before != null) {
                    assertThat(seen).as("Seed %d", seed).isEqualTo(before);
                }
            }
            different += met.size();
        }

        assertThat(different).as("States looked at").isGreaterThan(3000);
    }

    /** What a view shows, without ids: root missions in any order, for nothing depends on it where there are no globals. */
    private static List<Object> seen(EngineView view, EngineState state, Project project) {
        List<Object> missions = new ArrayList<>();
        view.missions().forEach(m -> {
            List<Object> words = new ArrayList<>(List.of(m.plan(), m.name(), m.status(), m.place()));
            m.marking()
                    .forEach((place, tokens) -> words.add(place
                            + tokens.stream()
                                    .map(t -> t.toString().replaceAll("mission=\\d+", ""))
                                    .toList()));
            project.plan(m.plan()).orElseThrow().variables().forEach(v -> words.add(view.variable(m.id(), v.name())));
            project.plan(m.plan())
                    .orElseThrow()
                    .transitions()
                    .forEach(t -> words.add(view.whyNotEnabled(m.id(), t.id()).reasons()));
            missions.add(words.toString());
        });
        return List.of(
                missions.stream().sorted().toList(),
                view.proxies(),
                view.decisions().stream()
                        .map(RandomStateKeyTest::words)
                        .sorted()
                        .toList(),
                project.globals().stream()
                        .map(v -> view.variable(Ids.NONE, v.name()))
                        .toList(),
                Set.copyOf(view.allocation().values()),
                view.openActivations().size(),
                view.nextDueMillis().isEmpty() ? -1 : view.nextDueMillis().getAsLong() - state.nowMillis());
    }

    private static String words(Decision d) {
        return d.type() + d.prompt() + d.question().toString().replaceAll("mission=\\d+", "");
    }
}
