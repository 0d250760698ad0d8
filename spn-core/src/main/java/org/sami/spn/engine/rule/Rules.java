package org.sami.spn.engine.rule;

import java.util.function.Consumer;
import org.sami.spn.engine.net.CompiledProject;
import org.sami.spn.engine.state.NetState;
import org.sami.spn.engine.state.OpenDecision;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.NoteKind;

/**
 * The rules, each in its own class, as the engine uses them. They work on the state of one step after the other, as searches make a state for nearly each
 * step; between two steps they know nothing of it.
 *
 * <p>Implements R-LOOK-8.
 */
public final class Rules {
    public final PendingOccurrences pendings;
    public final Routing routing;
    public final TokenPool pool;
    public final Enabling enabling;
    public final Firing firing;
    public final DueTimers timers;
    public final OpenQuestions questions;
    public final Decisions decisions;
    public final MissionStart missionStart;
    public final ProjectLoading projectLoading;
    public final Interrupts interrupts;
    public final VariableScopes scopes;
    public final TaskAllocation allocation;
    public final RobotRemoval robotRemoval;

    private final RuleStep step;
    private final FiringAgenda work;

    /** Rules that work on a state until a step {@linkplain #begin begins} on another. */
    public Rules(NetState state) {
        step = new RuleStep(state);
        work = new FiringAgenda(this::lookAt);
        MissionRules missions = new MissionRules(step, work, this::byAutonomy);
        firing = new Firing(step, missions);
        decisions = new Decisions(step, missions);
        projectLoading = new ProjectLoading(step);
        pendings = missions.pendings;
        routing = missions.routing;
        pool = missions.pool;
        enabling = missions.enabling;
        questions = missions.questions;
        missionStart = missions.missionStart;
        interrupts = missions.interrupts;
        scopes = missions.scopes;
        allocation = missions.allocation;
        robotRemoval = missions.robotRemoval;
        timers = new DueTimers(step, missions.timers, routing, decisions, firing, this::settle);
    }

    private void lookAt(TransitionState t) {
        firing.lookAt(t);
    }

    private void byAutonomy(OpenDecision open) {
        decisions.byAutonomy(open);
    }

    /** The state on which they work. */
    public NetState state() {
        return step.state;
    }

    /** A step on a state begins. */
    public void begin(NetState state, Consumer<? super Effect> effects) {
        step.begin(state, effects);
    }

    public void end() {
        step.end();
    }

    public void note(NoteKind kind, long mission, String message) {
        step.note(kind, mission, message);
    }

    /** Works until nothing is left to do. */
    public void settle() {
        work.run();
        for (Runnable next = step.nextOwnInput(); next != null; next = step.nextOwnInput()) {
            next.run();
            work.run();
        }
    }

    /** Whether nothing is left for the next step on the state, so that these rules may work on any other. */
    public boolean areDone() {
        return work.isDone() && step.isDone() && robotRemoval.isDone();
    }

    /** The project whose plans missions have that start now. */
    public CompiledProject project() {
        return step.project();
    }
}
