package org.sami.spn.engine.rule;

import java.util.ArrayDeque;
import java.util.function.Consumer;
import org.sami.spn.engine.net.CompiledProject;
import org.sami.spn.engine.state.NetState;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.value.TaskId;

/**
 * The rules for one state, each in its own class, and what they share during a step: effects, work list, own inputs.
 *
 * <p>Implements R-LOOK-8.
 */
public final class Rules {
    public final NetState state;
    public final WorkList work;
    public final PendingOccurrences pendings;
    public final Routing routing;
    public final TokenPool pool;
    public final Enabling enabling;
    public final Selection selection;
    public final Firing firing;
    public final TokenRemoval removal;
    public final Visits visits;
    public final Activating activating;
    public final Timers timers;
    public final Decisions decisions;
    public final RobotChoices robotChoices;
    public final SubMissions subMissions;
    public final SharedInstances sharedInstances;
    public final MissionStart missionStart;
    public final MissionEnd missionEnd;
    public final ProjectLoading projectLoading;
    public final Interrupts interrupts;
    public final Variables variables;
    public final TaskAllocation allocation;
    public final RobotRemoval robotRemoval;

    /** What the engine says to itself, taken one by one whenever the work list is empty. */
    private final ArrayDeque<Runnable> ownInputs = new ArrayDeque<>();

    private Consumer<? super Effect> sink = e -> {};

    public Rules(NetState state) {
        this.state = state;
        work = new WorkList(this);
        pendings = new PendingOccurrences(this);
        routing = new Routing(this);
        pool = new TokenPool();
        enabling = new Enabling(this);
        selection = new Selection(this);
        firing = new Firing(this);
        removal = new TokenRemoval(this);
        visits = new Visits(this);
        activating = new Activating(this);
        timers = new Timers(this);
        Questions questions = new Questions(this);
        decisions = new Decisions(this, questions);
        robotChoices = new RobotChoices(this, questions);
        subMissions = new SubMissions(this);
        sharedInstances = new SharedInstances(this);
        missionStart = new MissionStart(this);
        missionEnd = new MissionEnd(this);
        projectLoading = new ProjectLoading(this);
        interrupts = new Interrupts(this);
        variables = new Variables(this);
        allocation = new TaskAllocation(this);
        robotRemoval = new RobotRemoval(this);
    }

    public void begin(Consumer<? super Effect> effects) {
        sink = effects;
    }

    public void end() {
        sink = e -> {};
    }

    public void emit(Effect effect) {
        sink.accept(effect);
    }

    public void note(NoteKind kind, long mission, String message) {
        sink.accept(new Effect.Noted(kind, mission, message));
    }

    /** Posts an input of the engine to itself, after earlier ones and after the work list. */
    public void post(Runnable ownInput) {
        ownInputs.add(ownInput);
    }

    /** Works until nothing is left to do. */
    public void settle() {
        work.run();
        for (Runnable next = ownInputs.poll(); next != null; next = ownInputs.poll()) {
            next.run();
            work.run();
        }
    }

    /** The project whose plans missions have that start now. */
    public CompiledProject project() {
        return state.newest();
    }

    public TaskState task(TaskId id) {
        return state.task(id);
    }
}
