package org.sami.spn.engine;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledProject;
import org.sami.spn.engine.rule.Rules;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.NetState;
import org.sami.spn.engine.state.OpenDecision;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.model.Project;
import org.sami.spn.model.StartMarking;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Priority;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Runs the plans of a project: a deterministic function from state and input to state and effects (thesis,
 * Algorithms 1 to 3). It holds no state of a run itself and may be shared by threads; each {@link EngineState}
 * belongs to one thread at a time. Bad input never throws: it is answered by {@link Effect.Noted}.
 *
 * <p>Implements R-DET-1, R-DET-2, R-DET-5, R-DET-6.
 */
public final class Engine {
    /** How often a mission may fire without new input, by default. */
    public static final int DEFAULT_LIVELOCK_LIMIT = 10_000;

    private final CompiledProject project;
    /** Rules between two steps, for the next one of any state; null while a step works with them. Under this engine's lock. */
    private @Nullable Rules idle;

    /** An engine for the plans of a project; they are compiled here, once. */
    public Engine(Vocabulary vocabulary, Project project) {
        this(vocabulary, project, DEFAULT_LIVELOCK_LIMIT);
    }

    /**
     * An engine with its own idea of a livelock.
     *
     * @param livelockLimit how often one mission may fire without new input; the next firing halts it instead, as does one that would
     *     add more than ten times as many tokens, and more than a thousand
     */
    public Engine(Vocabulary vocabulary, Project project, int livelockLimit) {
        if (livelockLimit < 1) {
            throw new IllegalArgumentException("A livelock limit is at least 1, not " + livelockLimit);
        }
        this.project = new CompiledProject(
                Objects.requireNonNull(vocabulary, "vocabulary"),
                Objects.requireNonNull(project, "project"),
                livelockLimit);
    }

    /** The words that the plans use. */
    public Vocabulary vocabulary() {
        return project.vocabulary;
    }

    /** The plans with which sessions begin; what a session loaded later is asked of its {@link EngineView}. */
    public Project project() {
        return project.project;
    }

    /** A state in which nothing runs and no robot is known. */
    public EngineState newState() {
        return new EngineState(new NetState(project));
    }

    /** Questions about a state; the view follows the state through further steps. */
    public EngineView view(EngineState state) {
        return new StateView(state);
    }

    CompiledProject compiled() {
        return project;
    }

    /** As the other {@code step}, with the effects in a list. */
    public List<Effect> step(EngineState state, long nowMillis, Input input) {
        List<Effect> effects = new ArrayList<>();
        step(state, nowMillis, input, effects::add);
        return effects;
    }

    /**
     * Takes one input: first what is due until then, then the input, each followed by everything that it gives occasion
     * to. Changes the state in place.
     *
     * @param nowMillis the session's clock; a time before the last one counts as the last one
     * @param effects receives effects in order, while the state changes: it must not call back into the engine
     */
    public void step(EngineState state, long nowMillis, Input input, Consumer<? super Effect> effects) {
        run(state, nowMillis, effects, rules -> take(rules, input));
    }

    private void run(EngineState state, long nowMillis, Consumer<? super Effect> effects, Consumer<Rules> input) {
        if (state.net.first != project) {
            throw new IllegalArgumentException("The state belongs to another engine");
        }
        Rules rules = rulesFor(state);
        rules.begin(state.net, effects);
        try {
            rules.timers.runUntil(nowMillis);
            rules.firing.newChain();
            input.accept(rules);
            rules.settle();
        } finally {
            rules.end();
        }
        putBack(rules, state);
    }

    /** The rules that have something left to do for a state; else those that are idle; new ones while another thread works with those. */
    private Rules rulesFor(EngineState state) {
        Rules rules = state.unfinished() != null ? state.unfinished() : takeIdle();
        return rules != null ? rules : new Rules(state.net);
    }

    private synchronized @Nullable Rules takeIdle() {
        Rules taken = idle;
        idle = null;
        return taken;
    }

    private synchronized void keepIdle(Rules rules) {
        idle = rules;
    }

    private void putBack(Rules rules, EngineState state) {
        if (rules.areDone()) {
            state.keep(null);
            keepIdle(rules);
        } else {
            state.keep(rules);
        }
    }

    /**
     * Starts a root mission with a marking of one's own, for trying a plan from the middle. No input, so no journal holds it. What the
     * plan asks at its start and is not given has its default.
     *
     * @param effects as for {@link #step}; receives nothing where it is refused
     * @return why it cannot start so, in one sentence; empty where it started
     */
    public Optional<String> startAt(
            EngineState state,
            long nowMillis,
            Input.StartMission start,
            StartMarking marking,
            Consumer<? super Effect> effects) {
        List<String> refused = new ArrayList<>(0);
        run(
                state,
                nowMillis,
                effects,
                rules -> rules.missionStart.startAt(start, marking).ifPresent(refused::add));
        return refused.stream().findFirst();
    }

    private static void take(Rules rules, Input input) {
        Optional<String> refused = Optional.empty();
        long mission = Ids.NONE;
        if (input instanceof Input.Received received) {
            rules.routing.route(received.occurrence());
        } else if (input instanceof Input.StartMission start) {
            refused = rules.missionStart.start(start);
        } else if (input instanceof Input.LoadProject load) {
            refused = rules.projectLoading.load(load);
        } else if (input instanceof Input.AnswerDecision answer) {
            OpenDecision open = rules.state().decisions.get(answer.decision());
            mission = open == null ? Ids.NONE : open.decision.mission();
            refused = rules.decisions.answer(answer);
        } else if (input instanceof Input.HoldDecision hold) {
            OpenDecision open = rules.state().decisions.get(hold.decision());
            mission = open == null ? Ids.NONE : open.decision.mission();
            refused = rules.decisions.hold(hold.decision());
        } else if (input instanceof Input.Interrupt press) {
            rules.interrupts.interrupt(press);
        } else if (input instanceof Input.AbortMission abort) {
            refused = stop(rules, abort.mission(), true);
        } else if (input instanceof Input.CompleteMission complete) {
            refused = stop(rules, complete.mission(), false);
        } else if (input instanceof Input.ProxyJoined joined) {
            rules.state().addProxies(List.of(joined.proxy()));
        } else if (input instanceof Input.ProxyDropped dropped) {
            refused = rules.robotRemoval.drop(dropped);
        } else if (input instanceof Input.AllocateTasks tasks) {
            rules.allocation.allocate(tasks.allocation(), Priority.MEDIUM);
        } else if (input instanceof Input.AddTasks tasks) {
            refused = rules.allocation.add(tasks);
        } else if (input instanceof Input.SetVariable write) {
            refused = set(rules, write);
        } else if (input instanceof Input.HandlerFailed failed) {
            SentActivation sent = rules.state().sent.get(failed.activation());
            rules.note(
                    NoteKind.HANDLER_FAILED,
                    sent == null ? Ids.NONE : sent.activation.mission(),
                    (sent == null ? "Activation " + failed.activation() : sent.activation.type()) + " failed: "
                            + failed.reason());
        } else if (input instanceof Input.Remember remember) {
            refused = remember(rules, remember);
        } else if (input instanceof Input.AskOperator asked) {
            rules.questions.ask(asked);
        } else if (input instanceof Input.WithdrawQuestion withdrawn) {
            rules.questions.withdraw(withdrawn);
        }
        if (refused.isPresent()) {
            rules.note(NoteKind.REJECTED_INPUT, mission, refused.get());
        }
    }

    private static Optional<String> stop(Rules rules, long id, boolean abort) {
        if (id == Ids.NONE && abort) {
            for (MissionState m : List.copyOf(rules.state().missions.values())) {
                if (m.parent == null) {
                    rules.interrupts.abort(m);
                }
            }
            return Optional.empty();
        }
        MissionState m = rules.state().missions.get(id);
        if (m == null) {
            return Optional.of("There is no running mission " + id);
        }
        if (abort) {
            rules.interrupts.abort(m);
        } else {
            rules.interrupts.complete(m);
        }
        return Optional.empty();
    }

    private static Optional<String> set(Rules rules, Input.SetVariable write) {
        MissionState m = rules.state().missions.get(write.mission());
        if (m == null && write.mission() != Ids.NONE) {
            return Optional.of("There is no running mission " + write.mission());
        }
        if (m == null && !rules.project().globals.containsKey(write.variable())) {
            return Optional.of("The project declares no variable " + write.variable());
        }
        rules.scopes.write(m, write.variable(), write.value());
        return Optional.empty();
    }

    private static Optional<String> remember(Rules rules, Input.Remember remember) {
        if (remember.mission() == Ids.NONE) {
            rules.state().memory.put(remember.key(), remember.value());
            return Optional.empty();
        }
        MissionState m = rules.state().missions.get(remember.mission());
        if (m == null) {
            return Optional.of(
                    "There is no running mission " + remember.mission() + " to remember '" + remember.key() + "' for");
        }
        m.remember(remember.key(), remember.value());
        return Optional.empty();
    }
}
