package org.sami.spn.engine;

import java.util.ArrayDeque;
import java.util.function.Consumer;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.value.TaskId;

/** The rules for one state, each in its own class, and what they share during a step: effects, work list, own inputs. */
final class Rules {
    final NetState state;
    final WorkList work;
    final Pendings pendings;
    final Routing routing;
    final Pool pool;
    final Enabling enabling;
    final Selection selection;
    final Firing firing;
    final Leaving leaving;
    final Visits visits;
    final Activating activating;
    final Timers timers;
    final Decisions decisions;
    final SubMissions subMissions;
    final SharedInstances sharedInstances;
    final MissionStart missionStart;
    final MissionEnd missionEnd;
    final Presses presses;
    final Variables variables;
    final Allocation allocation;
    final Drops drops;

    /** What the engine says to itself, taken one by one whenever the work list is empty. */
    private final ArrayDeque<Runnable> ownInputs = new ArrayDeque<>();

    private Consumer<? super Effect> sink = e -> {};

    Rules(NetState state) {
        this.state = state;
        work = new WorkList(this);
        pendings = new Pendings(this);
        routing = new Routing(this);
        pool = new Pool();
        enabling = new Enabling(this);
        selection = new Selection(this);
        firing = new Firing(this);
        leaving = new Leaving(this);
        visits = new Visits(this);
        activating = new Activating(this);
        timers = new Timers(this);
        decisions = new Decisions(this);
        subMissions = new SubMissions(this);
        sharedInstances = new SharedInstances(this);
        missionStart = new MissionStart(this);
        missionEnd = new MissionEnd(this);
        presses = new Presses(this);
        variables = new Variables(this);
        allocation = new Allocation(this);
        drops = new Drops(this);
    }

    void begin(Consumer<? super Effect> effects) {
        sink = effects;
    }

    void end() {
        sink = e -> {};
    }

    void emit(Effect effect) {
        sink.accept(effect);
    }

    void note(NoteKind kind, long mission, String message) {
        sink.accept(new Effect.Noted(kind, mission, message));
    }

    /** Says something to itself, after what was said before and after the work list. */
    void post(Runnable ownInput) {
        ownInputs.add(ownInput);
    }

    /** Works until nothing is left to do. */
    void settle() {
        work.run();
        for (Runnable next = ownInputs.poll(); next != null; next = ownInputs.poll()) {
            next.run();
            work.run();
        }
    }

    CompiledProject project() {
        return state.project;
    }

    TaskState task(TaskId id) {
        return state.task(id);
    }
}
