package org.sami.spn.reference;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.model.Place;
import org.sami.spn.model.Project;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/** Everything that the interpreter knows, in plain lists. */
final class World {
    /** A transition that is to be looked at. */
    record Look(Mission mission, Transition transition) {}

    /**
     * A question that is open.
     *
     * @param ofStanding whether it offers boats because they stood in the place, which nobody entered
     */
    record Question(Decision decision, Optional<Visit> visit, boolean ofStanding) {
        Question(Decision decision, Optional<Visit> visit) {
            this(decision, visit, false);
        }

        /** The boats that it offers because they stood there. */
        List<String> standing() {
            return ofStanding && decision.question() instanceof org.sami.spn.protocol.Question.ChooseProxies c
                    ? c.proxies()
                    : List.of();
        }
    }

    /**
     * A clock that runs: of a timer activation (for one token, with a per-boat timer) or of a decision's deadline.
     *
     * @param order in which clocks were started
     */
    record Clock(long dueMillis, long order, Optional<Activation> timer, Optional<Token> token, long decision) {}

    /** Random plans that double their tokens in a ring are of no interest beyond this many in a place. */
    static final int MOST_TOKENS = 60;

    /** A random plan that breeds tokens. */
    static final class TooManyTokens extends RuntimeException {}

    final Vocabulary vocabulary;
    /** The newest: missions that start now are of it. */
    Project project;

    int projectVersion = 1;
    final int livelockLimit;
    final List<String> proxies = new ArrayList<>();
    final Map<String, Value> globals = new LinkedHashMap<>();
    final List<Mission> missions = new ArrayList<>();
    final Map<TaskId, String> allocation = new LinkedHashMap<>();
    final Map<Long, Visit> visitOfActivation = new LinkedHashMap<>();
    final List<Question> questions = new ArrayList<>();
    final List<Clock> clocks = new ArrayList<>();
    final Deque<Look> work = new ArrayDeque<>();
    /** What the engine itself causes and takes once the work list is empty. */
    final Deque<Runnable> internal = new ArrayDeque<>();

    final List<Effect> effects = new ArrayList<>();
    long now;
    long nextMission = 1;
    long nextVisit = 1;
    long nextActivation = 1;
    final Map<String, Value> memory = new LinkedHashMap<>();
    long nextDecision = 1;
    long nextClock = 1;
    long firings;
    long visitsEnded;

    World(Vocabulary vocabulary, Project project, int livelockLimit) {
        this.vocabulary = vocabulary;
        this.project = project;
        this.livelockLimit = livelockLimit;
        project.globals().forEach(v -> v.initial().ifPresent(value -> globals.put(v.name(), value)));
    }

    void note(NoteKind kind, long mission, String message) {
        effects.add(new Effect.Noted(kind, mission, message));
    }

    Optional<Mission> mission(long id) {
        return missions.stream()
                .filter(m -> m.id == id && m.status != Mission.Status.ENDED)
                .findFirst();
    }

    EventType eventType(String name) {
        return vocabulary.event(name).orElseThrow();
    }

    /** What is on the list already keeps its position (R-LOOK-6). */
    void lookAt(Mission mission, Transition transition) {
        Look look = new Look(mission, transition);
        if (mission.reacts() && !work.contains(look)) {
            work.add(look);
        }
    }

    /** The task that one stands for in a child, or the task itself. */
    TaskId owned(TaskId id) {
        TaskId original =
                mission(id.mission()).map(m -> m.standsFor.get(id.name())).orElse(null);
        return original == null ? id : owned(original);
    }

    /** The boat that a task of a running mission is allocated to. */
    Optional<String> boatOf(TaskId id) {
        return task(id).flatMap(task -> Optional.ofNullable(allocation.get(owned(id))));
    }

    /** The boat of a proxy token, or of a task token that has one. */
    Optional<String> boatOf(Token token) {
        if (token instanceof Token.Proxy proxy) {
            return Optional.of(proxy.proxy());
        }
        return token instanceof Token.Task task ? boatOf(task.task()) : Optional.empty();
    }

    Optional<TaskSpec> task(TaskId id) {
        return mission(id.mission()).flatMap(m -> Optional.ofNullable(m.tasks.get(id.name())));
    }

    /** Whether a transition is one of those that no running sub-mission keeps out: interrupts, abort, complete. */
    boolean overrides(Transition t) {
        return t.inputs().stream().map(i -> eventType(i.type()).role()).anyMatch(World::overrides);
    }

    static boolean overrides(EventRole role) {
        return isInterrupt(role) || role == EventRole.ABORT_RECEIVED || role == EventRole.COMPLETE_RECEIVED;
    }

    static boolean isInterrupt(EventRole role) {
        return role == EventRole.INTERRUPT
                || role == EventRole.GENERAL_INTERRUPT_RECEIVED
                || role == EventRole.PROXY_INTERRUPT_RECEIVED;
    }

    /** Whether it waits for the operator to answer for an aborted child. */
    boolean awaitsAborted(Transition t) {
        return t.inputs().stream().anyMatch(i -> eventType(i.type()).role() == EventRole.SUB_MISSION_ABORTED);
    }

    /** The in places of a transition except one. */
    static List<Place> others(List<Place> places, Place without) {
        return places.stream().filter(p -> !p.equals(without)).toList();
    }
}
