package org.sami.spn.engine;

import java.util.Set;
import org.sami.spn.engine.codec.AlikeState;
import org.sami.spn.value.TaskId;

/**
 * Names a state by what it means as {@link StateKey} does, but not by which of the robots and made tasks is which, by the order in which they
 * came where no requirement takes some number of them, by where points lie, or by how long timers have to run: two states with equal keys go on
 * alike with other names, as long as timers run down in the same order. For searches, which would otherwise look at every exchange apart.
 */
public final class AlikeKey {
    private final AlikeState state;

    private AlikeKey(AlikeState state) {
        this.state = state;
    }

    /**
     * The key of a state as it is now; between two steps only.
     *
     * @param robots names of robots that are like one another: no plan speaks of them
     */
    public static AlikeKey of(EngineState state, Set<String> robots) {
        return new AlikeKey(new AlikeState(state.net, robots));
    }

    /** Adds that a robot has a task left, as the domain knows: in which turn, and whether it has begun. */
    public void left(String robot, int turn, TaskId task, boolean begun) {
        state.left(robot, turn, task, begun);
    }

    /** The bytes, for this version of the program only. */
    public byte[] bytes() {
        return state.bytes();
    }
}
