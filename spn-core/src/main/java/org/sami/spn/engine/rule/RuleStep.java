package org.sami.spn.engine.rule;

import java.util.ArrayDeque;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledProject;
import org.sami.spn.engine.state.NetState;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.value.TaskId;

/** What all rules share during a step: the state that they change, which is another one in each step; its effects; and what the engine says to itself. */
public final class RuleStep {
    public NetState state;

    /** What the engine says to itself, taken one by one whenever the work list is empty. */
    private final ArrayDeque<Runnable> ownInputs = new ArrayDeque<>(2);

    private Consumer<? super Effect> sink = e -> {};

    RuleStep(NetState state) {
        this.state = state;
    }

    void begin(NetState changed, Consumer<? super Effect> effects) {
        state = changed;
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

    /** Posts an input of the engine to itself, after earlier ones and after the work list. */
    void post(Runnable ownInput) {
        ownInputs.add(ownInput);
    }

    /** The next input of the engine to itself; null where there is none. */
    @Nullable
    Runnable nextOwnInput() {
        return ownInputs.poll();
    }

    /** Whether the engine says nothing to itself any longer. */
    boolean isDone() {
        return ownInputs.isEmpty();
    }

    /** The project whose plans missions have that start now. */
    CompiledProject project() {
        return state.newest();
    }

    /** A task of a running mission; null where it has ended. */
    @Nullable
    TaskState task(TaskId id) {
        return state.task(id);
    }
}
