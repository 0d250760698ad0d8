package org.sami.crw.sim.run.incident;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.sami.crw.session.Session;
import org.sami.crw.sim.run.incident.IncidentKind.PlannedIncident;
import org.sami.crw.sim.run.incident.ScriptStep.BoatChoice;
import org.sami.crw.sim.run.settings.Parameters;
import org.sami.session.api.RefusedException;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Ids;
import org.sami.spn.value.Value;

/**
 * Plays an operator's script on a session: the steps of the start, then those of each incident, one after another. It is over when no root mission
 * runs after a step and nothing is left to do. For the engine's thread.
 */
final class ScriptPlayer {
    private static final long AGAIN_MILLIS = 1000;

    private final IncidentRunInput input;
    private final Session session;
    private final LongSupplier clock;
    private final ScriptedAnswers answers;
    private final LocationsToVisit locations;
    private final RunMissions missions;
    private final PressOutcome press;
    private final IncidentQueue queue;
    private final Deque<ScriptStep> steps = new ArrayDeque<>();
    private final List<PlannedIncident> placed = new ArrayList<>();
    private Optional<PlannedIncident> incident = Optional.empty();
    private Optional<String> fault = Optional.empty();
    private boolean begun;
    private boolean over;
    private boolean acting; // the first step has begun
    private int turn; // of the boats that are chosen one after another, from 1
    private boolean started; // the mission that is being started runs
    private long untilMillis;

    ScriptPlayer(
            IncidentRunInput input,
            Session session,
            ScriptedAnswers answers,
            LocationsToVisit locations,
            RunMissions missions,
            PressOutcome press,
            IncidentQueue queue) {
        this.input = input;
        this.session = session;
        this.answers = answers;
        this.locations = locations;
        this.missions = missions;
        this.press = press;
        this.queue = queue;
        clock = session.scheduler()::nowMs;
    }

    /** Begins, once all boats are there. */
    void begin() {
        if (!begun) {
            begun = true;
            steps.addAll(input.script().start());
            BackgroundActions background = input.script().background();
            if (!background.areNone()) {
                steps.add(new ScriptStep.Start(background.plan(), Map.of(), BoatChoice.ALL, false));
            }
        }
    }

    boolean hasBegun() {
        return begun;
    }

    /** Goes on as far as possible; called after everything that happens. */
    void look() {
        while (begun && !over && fault.isEmpty()) {
            if (steps.isEmpty() && !next()) {
                return;
            }
            if (steps.isEmpty()) {
                continue;
            }
            boolean done = acting ? isDone(steps.peek()) : act(steps.peek());
            acting = !done;
            if (!done) {
                return;
            }
            steps.poll();
        }
    }

    /** Takes the next incident; false where nothing is to be done now. */
    private boolean next() {
        incident = Optional.empty();
        if (!missions.anyRoot()) {
            over = true;
            return false;
        }
        incident = queue.due(clock.getAsLong() - missions.firstStart().orElse(0));
        incident.ifPresent(now -> {
            placed.add(new PlannedIncident(
                    clock.getAsLong() - missions.firstStart().orElse(0), now.boats()));
            steps.addAll(input.script().onIncident());
        });
        return incident.isPresent();
    }

    /** Begins a step; whether it is done at once. */
    private boolean act(ScriptStep step) {
        if (step instanceof ScriptStep.Start start) {
            return start.boats() == BoatChoice.EACH_BUT_ONE ? oneAfterAnother(start) : start(start);
        }
        if (step instanceof ScriptStep.Abort abort) {
            missions.rootsOf(abort.plan()).forEach(session::abort);
        } else if (step instanceof ScriptStep.Press pressed) {
            press(pressed);
        } else if (step instanceof ScriptStep.Pause pause) {
            untilMillis = clock.getAsLong() + pause.millis();
            session.scheduler().after(pause.millis(), () -> {}); // so that somebody looks then
        }
        return isDone(step);
    }

    private boolean isDone(ScriptStep step) {
        if (step instanceof ScriptStep.Start) {
            return started;
        }
        if (step instanceof ScriptStep.Abort abort) {
            return missions.rootsOf(abort.plan()).isEmpty();
        }
        if (step instanceof ScriptStep.Await await) {
            return !missions.isRunning(await.plan());
        }
        if (step instanceof ScriptStep.Press pressed) {
            return isPressDone(pressed);
        }
        return clock.getAsLong() >= untilMillis;
    }

    private boolean isPressDone(ScriptStep.Press pressed) {
        if (press.isTaken() || !missions.anyRoot()) {
            return true;
        }
        if (press.isRefused() && clock.getAsLong() >= untilMillis) {
            press(pressed);
        }
        return false;
    }

    private void press(ScriptStep.Press pressed) {
        if (missions.anyRoot()) {
            press.pressing();
            untilMillis = clock.getAsLong() + AGAIN_MILLIS;
            session.press(pressed.interrupt(), Ids.NONE, pressed.namesBoats() ? boats(BoatChoice.INCIDENT) : List.of());
        }
    }

    /** Puts a start and its end for each boat in the place of a step. */
    private boolean oneAfterAnother(ScriptStep.Start step) {
        List<ScriptStep> later = new ArrayList<>(steps);
        later.remove(0);
        steps.clear();
        steps.add(step); // is done, and is taken off
        int boats = incident.map(PlannedIncident::boats).orElse(List.of()).size() - 1;
        for (int i = 0; i < boats; i++) {
            steps.add(new ScriptStep.Start(step.plan(), step.values(), BoatChoice.NEXT, step.ifUnvisited()));
            steps.add(new ScriptStep.Await(step.plan()));
        }
        steps.addAll(later);
        turn = 0;
        return true;
    }

    private boolean start(ScriptStep.Start start) {
        turn += start.boats() == BoatChoice.NEXT ? 1 : 0;
        if (start.ifUnvisited() && locations.unvisited().isEmpty()) {
            return true;
        }
        Plan plan = input.project().plan(start.plan()).orElseThrow();
        Map<String, Value> values = new Parameters(input.vocabulary(), input.project(), plan).read(start.values());
        answers.choose(
                start.plan(), start.boats() == BoatChoice.ALL ? Optional.empty() : Optional.of(boats(start.boats())));
        started = false;
        session.start(start.plan(), plan.name(), values).whenComplete((mission, refused) -> {
            started = refused == null;
            if (refused != null) {
                fault = Optional.of(start.plan() + " did not start: " + RefusedException.reason(refused));
            }
        });
        return false;
    }

    private List<String> boats(BoatChoice choice) {
        List<String> named = incident.map(PlannedIncident::boats).orElse(List.of());
        List<String> all = input.fleet().boatNames();
        if (choice == BoatChoice.OTHERS) {
            return all.stream().filter(boat -> !named.contains(boat)).toList();
        }
        if (choice == BoatChoice.NEXT) {
            return named.subList(turn - 1, turn);
        }
        return choice == BoatChoice.ALL ? all : named;
    }

    /** Whether the script has come to its end. */
    boolean isOver() {
        return over;
    }

    /** Why it cannot go on, in a sentence. */
    Optional<String> fault() {
        return fault;
    }

    /** The incidents that were resolved, or are being resolved. */
    List<PlannedIncident> placed() {
        return List.copyOf(placed);
    }
}
