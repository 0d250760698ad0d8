package org.sami.spn.engine.rule;

import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledProject;
import org.sami.spn.engine.state.NetState;
import org.sami.spn.engine.state.OpenDecision;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.value.TaskId;

/**
 * How missions, their visits and their sub-missions begin and end. These rules follow from one another: a place that is entered starts
 * instances, whose end may end the visit and the parent. What they use besides knows none of them.
 */
final class MissionRules {
    final RuleStep step;
    final FiringAgenda work;
    final TokenPool pool = new TokenPool();
    final Enabling enabling;
    final PendingOccurrences pendings;
    final Routing routing;
    final Timers timers;
    final VariableScopes scopes;
    final TaskAllocation allocation;
    final OpenQuestions questions;
    final RobotChoices robotChoices;

    final TokenRemoval removal = new TokenRemoval(this);
    final Visits visits = new Visits(this);
    final Activating activating = new Activating(this);
    final SubMissions subMissions = new SubMissions(this);
    final SharedInstances sharedInstances = new SharedInstances(this);
    final MissionStart missionStart = new MissionStart(this);
    final MissionEnd missionEnd = new MissionEnd(this);
    final Interrupts interrupts = new Interrupts(this);
    final RobotRemoval robotRemoval = new RobotRemoval(this);

    /**
     * The rules for the state of a step.
     *
     * @param autonomy answers a question that is not left to the operator
     */
    MissionRules(RuleStep step, FiringAgenda work, Consumer<OpenDecision> autonomy) {
        this.step = step;
        this.work = work;
        enabling = new Enabling(step, pool);
        pendings = new PendingOccurrences(step, enabling, work);
        routing = new Routing(step, enabling, pendings);
        timers = new Timers(step);
        scopes = new VariableScopes(step);
        allocation = new TaskAllocation(step, pendings);
        Questions asked = new Questions(step, pendings, scopes);
        questions = new OpenQuestions(step, asked, timers, autonomy);
        robotChoices = new RobotChoices(step, asked, questions, timers, autonomy);
    }

    /** The state that the step changes. */
    NetState state() {
        return step.state;
    }

    void emit(Effect effect) {
        step.emit(effect);
    }

    void note(NoteKind kind, long mission, String message) {
        step.note(kind, mission, message);
    }

    /** Posts an input of the engine to itself, after earlier ones and after the work list. */
    void post(Runnable ownInput) {
        step.post(ownInput);
    }

    /** The project whose plans missions have that start now. */
    CompiledProject project() {
        return step.project();
    }

    @Nullable
    TaskState task(TaskId id) {
        return step.task(id);
    }
}
