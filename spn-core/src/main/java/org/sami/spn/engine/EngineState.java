package org.sami.spn.engine;

import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.rule.Rules;
import org.sami.spn.engine.state.NetState;
import org.sami.spn.engine.state.StateCopy;

/**
 * Everything that an engine knows between two steps. Changed in place by {@link Engine#step}; {@link #copy()} gives an
 * independent one; {@link EngineView} answers questions about it. Owned by one thread at a time.
 */
public final class EngineState {
    final NetState net;
    /** Rules that have something left to do in the next step; null where nothing is left. */
    private @Nullable Rules unfinished;

    EngineState(NetState net) {
        this.net = net;
    }

    /** An independent state that behaves in the same way for all further inputs. */
    public EngineState copy() {
        return new EngineState(StateCopy.of(net));
    }

    /** How many firings there were in the session. */
    public long firings() {
        return net.firings;
    }

    /** The time of the last step, in milliseconds on the session's clock. */
    public long nowMillis() {
        return net.now;
    }

    /** The rules with what an earlier step has left to do; null where it left nothing. */
    @Nullable
    Rules unfinished() {
        return unfinished;
    }

    /** Keeps rules for the next step, or none where they are done. */
    void keep(@Nullable Rules rules) {
        unfinished = rules;
    }
}
